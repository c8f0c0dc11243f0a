// SPDX-License-Identifier: MIT
#pragma once
#include <hdf5.h>
#include <filesystem>
#include <stdexcept>
#include <string>
#include <utility>

// The HDF5 library behind owned handles and exceptions.
namespace mpm::io::hdf5 {

/// Keeps the library from printing its error stack while alive: failures are thrown instead.
class QuietErrors {
 public:
  QuietErrors() {
    H5Eget_auto2(H5E_DEFAULT, &print_, &data_);
    H5Eset_auto2(H5E_DEFAULT, nullptr, nullptr);
  }
  ~QuietErrors() { H5Eset_auto2(H5E_DEFAULT, print_, data_); }
  QuietErrors(const QuietErrors&) = delete;
  QuietErrors& operator=(const QuietErrors&) = delete;

 private:
  H5E_auto2_t print_ = nullptr;
  void* data_ = nullptr;
};

/// The library's own words on the call that failed last: the innermost entry of its error stack.
inline std::string last_error() {
  std::string text;
  const auto innermost = [](unsigned depth, const H5E_error2_t* entry, void* out) -> herr_t {
    if (depth == 0 && entry->desc) *static_cast<std::string*>(out) = entry->desc;
    return 0;
  };
  H5Ewalk2(H5E_DEFAULT, H5E_WALK_UPWARD, innermost, &text);
  return text;
}

/// Passes the result of an HDF5 call on. Throws std::runtime_error naming the file, the call and the reason if it is
/// negative, the library's mark of failure.
template <class Result>
Result check(Result result, const char* call, const std::filesystem::path& file) {
  if (result < 0) throw std::runtime_error(file.string() + ": " + call + " failed: " + last_error());
  return result;
}

/// An HDF5 identifier, closed when it goes out of scope.
class Handle {
 public:
  using Close = herr_t (*)(hid_t);

  /// Owns `id`. Throws std::runtime_error, as check() does, if the call that made it failed.
  Handle(hid_t id, Close closer, const char* call, const std::filesystem::path& file)
      : id_(check(id, call, file)), close_(closer) {}
  Handle(Handle&& other) noexcept : id_(std::exchange(other.id_, H5I_INVALID_HID)), close_(other.close_) {}
  Handle& operator=(Handle&&) = delete;
  ~Handle() {
    if (id_ >= 0) close_(id_);
  }

  operator hid_t() const { return id_; }

 private:
  hid_t id_;
  Close close_;
};

}  // namespace mpm::io::hdf5
