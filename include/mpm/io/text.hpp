// SPDX-License-Identifier: MIT
#pragma once
#include <cerrno>
#include <charconv>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <stdexcept>
#include <string>
#include <string_view>
#include <system_error>

// Numbers and files as text, the same in every locale.
namespace mpm::io {

/// The shortest decimal text that reads back as the same double; `nan`, `inf`, `-inf` where it is not finite.
inline std::string number(double value) {
  if (std::isnan(value)) return "nan";  // to_chars would keep its sign
  char text[32];
  return {text, std::to_chars(text, text + sizeof text, value).ptr};
}

/// `text` as a JSON string, quotes included. `text` is UTF-8.
inline std::string json_string(std::string_view text) {
  std::string out = "\"";
  for (const char c : text) {
    if (c == '"' || c == '\\') {
      out += '\\';
      out += c;
    } else if (static_cast<unsigned char>(c) < 0x20) {
      char code[7];
      std::snprintf(code, sizeof code, "\\u%04x", static_cast<unsigned>(c));
      out += code;
    } else {
      out += c;
    }
  }
  return out + '"';
}

/// `value` as JSON, which has no NaN and no infinity: those become `null`.
inline std::string json_number(double value) {
  return std::isfinite(value) ? number(value) : "null";
}

/// Puts `bytes` into `file` at once: a reader, or a run killed half-way, sees the old content or the new, never a part.
/// Throws std::runtime_error naming the file, the call and the reason; the old content then stands.
inline void replace_file(const std::filesystem::path& file, std::string_view bytes) {
  const auto part = std::filesystem::path(file) += ".part";
  const char* call = "fopen";
  errno = 0;
  std::FILE* out = std::fopen(part.c_str(), "wb");
  bool good = out != nullptr;
  if (good) {
    call = "fwrite";
    good = std::fwrite(bytes.data(), 1, bytes.size(), out) == bytes.size() && std::fflush(out) == 0;
    const int reason = errno;
    good = std::fclose(out) == 0 && good;
    errno = reason;
  }
  if (good) {
    call = "rename";
    good = std::rename(part.c_str(), file.c_str()) == 0;
  }
  if (good) return;
  const std::string reason = std::generic_category().message(errno);
  std::remove(part.c_str());
  throw std::runtime_error(file.string() + ": " + call + ": " + reason);
}

}  // namespace mpm::io
