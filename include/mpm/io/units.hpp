// SPDX-License-Identifier: MIT
#pragma once
#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <numeric>
#include <stdexcept>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

// Numbers with units: text to SI and back. Every unit here is a power of ten of its SI unit, so that a value is scaled
// by shifting its decimal exponent, in the text and never in floating point: `1.32 g/cm^3` is exactly the double 1320,
// and what was written reads back to the same bits.
namespace mpm::io {

/// The user's input cannot be used. `what()` says where, which key and value, what is wrong and what to do, always in
/// one line: control characters in what the user wrote are shown as `?`.
struct InputError : std::runtime_error {
  explicit InputError(std::string message) : std::runtime_error(one_line(std::move(message))) {}

 private:
  static std::string one_line(std::string text) {
    std::replace_if(
        text.begin(), text.end(), [](unsigned char c) { return c < 0x20 || c == 0x7f; }, '?');
    return text;
  }
};

/// Powers of metre, kilogram and second.
using Dimension = std::array<int, 3>;

/// A unit: its dimension and the power of ten that makes it SI.
struct Unit {
  Dimension dimension{};
  int power = 0;
};

/// Text as a message shows it: in quotes and cut to a readable length.
inline std::string shown(std::string_view text) {
  constexpr std::size_t longest = 60;
  return '"' + std::string(text.substr(0, longest)) + (text.size() > longest ? "...\"" : "\"");
}

/// Text without the white space around it.
inline std::string_view trimmed(std::string_view text) {
  constexpr std::string_view space = " \t\r\n\f\v";
  const auto first = text.find_first_not_of(space);
  return first == text.npos ? std::string_view{} : text.substr(first, text.find_last_not_of(space) - first + 1);
}

/// The number of letters to insert, remove or replace to turn one word into the other (Levenshtein).
inline std::size_t edit_distance(std::string_view a, std::string_view b) {
  std::vector<std::size_t> row(b.size() + 1);
  std::iota(row.begin(), row.end(), std::size_t{0});
  for (std::size_t i = 0; i < a.size(); ++i) {
    std::size_t diagonal = row[0]++;
    for (std::size_t j = 0; j < b.size(); ++j) {
      const std::size_t replaced = diagonal + (a[i] == b[j] ? 0 : 1);
      diagonal = row[j + 1];
      row[j + 1] = std::min({replaced, row[j] + 1, row[j + 1] + 1});
    }
  }
  return row.back();
}

/// The candidate nearest to a mistyped word; the first one of equals.
inline std::string nearest(std::string_view word, const std::vector<std::string>& candidates) {
  return *std::min_element(candidates.begin(), candidates.end(), [&](const std::string& a, const std::string& b) {
    return edit_distance(word, a) < edit_distance(word, b);
  });
}

namespace detail {

struct Symbol {
  std::string_view name;
  Unit unit;
};

inline constexpr Symbol symbols[] = {
    {"m", {{1, 0, 0}, 0}},    {"km", {{1, 0, 0}, 3}},    {"cm", {{1, 0, 0}, -2}},   {"mm", {{1, 0, 0}, -3}},
    {"um", {{1, 0, 0}, -6}},  {"kg", {{0, 1, 0}, 0}},    {"g", {{0, 1, 0}, -3}},    {"s", {{0, 0, 1}, 0}},
    {"ms", {{0, 0, 1}, -3}},  {"us", {{0, 0, 1}, -6}},   {"ns", {{0, 0, 1}, -9}},   {"N", {{1, 1, -2}, 0}},
    {"Pa", {{-1, 1, -2}, 0}}, {"kPa", {{-1, 1, -2}, 3}}, {"MPa", {{-1, 1, -2}, 6}}, {"GPa", {{-1, 1, -2}, 9}},
    {"J", {{2, 1, -2}, 0}},   {"kJ", {{2, 1, -2}, 3}},   {"MJ", {{2, 1, -2}, 6}},
};

inline Unit symbol(std::string_view name) {
  for (const auto& s : symbols)
    if (s.name == name) return s.unit;
  std::vector<std::string> names;
  for (const auto& s : symbols) names.emplace_back(s.name);
  throw InputError("unknown unit " + shown(name) + ", the nearest known one is " + nearest(name, names));
}

/// "cm^3", "s": a symbol with an optional exponent from -9 to 9.
inline Unit factor(std::string_view text) {
  const auto caret = text.find('^');
  Unit unit = symbol(text.substr(0, caret));
  if (caret == text.npos) return unit;
  int exponent = 0;
  const auto [end, error] = std::from_chars(text.data() + caret + 1, text.data() + text.size(), exponent);
  if (error != std::errc{} || end != text.data() + text.size() || std::abs(exponent) > 9)
    throw InputError("the exponent of " + shown(text) + " is not a small integer");
  for (int& d : unit.dimension) d *= exponent;
  unit.power *= exponent;
  return unit;
}

/// Decimal digits with the point behind the first of them, times ten to the exponent.
struct Decimal {
  std::string sign, digits;
  int exponent = 0;
};

inline Decimal shortest(double value) {
  std::array<char, 40> buffer{};
  const auto end = std::to_chars(buffer.begin(), buffer.end(), value, std::chars_format::scientific).ptr;
  const std::string text(buffer.begin(), end);
  const auto e = text.find('e');
  Decimal d{"", text.substr(0, e), std::stoi(text.substr(e + 1))};
  if (d.digits.front() == '-') d.sign = "-", d.digits.erase(0, 1);
  if (d.digits.size() > 1) d.digits.erase(1, 1);
  return d;
}

inline std::string layout(Decimal d) {
  if (d.exponent < -4 || d.exponent > 9) {
    if (d.digits.size() > 1) d.digits.insert(1, ".");
    return d.sign + d.digits + 'e' + std::to_string(d.exponent);
  }
  if (d.exponent < 0) return d.sign + "0." + std::string(static_cast<std::size_t>(-d.exponent - 1), '0') + d.digits;
  const auto whole = static_cast<std::size_t>(d.exponent) + 1;
  if (d.digits.size() <= whole) return d.sign + d.digits + std::string(whole - d.digits.size(), '0');
  return d.sign + d.digits.insert(whole, ".");
}

}  // namespace detail

/// Reads a unit such as `mm`, `g/cm^3`, `J/m^2`; empty text is the dimensionless unit. `/` divides by the one factor
/// behind it. Throws InputError for an unknown symbol.
inline Unit parse_unit(std::string_view text) {
  Unit unit;
  int sign = 1;
  while (!text.empty()) {
    const auto end = std::min(text.find_first_of("*/"), text.size());
    const Unit f = detail::factor(text.substr(0, end));
    for (std::size_t i = 0; i < unit.dimension.size(); ++i) unit.dimension[i] += sign * f.dimension[i];
    unit.power += sign * f.power;
    if (end == text.size()) break;
    sign = text[end] == '/' ? -1 : 1;
    text.remove_prefix(end + 1);
    if (text.empty()) throw InputError("a unit ends in * or /");
  }
  return unit;
}

/// Reads a finite number and an optional unit of the dimension of `expected`; a bare number is SI. Returns the SI
/// value, the double nearest to what was written. Throws InputError: not a number, unknown unit, wrong dimension.
inline double parse_quantity(std::string_view written, std::string_view expected) {
  const std::string_view text = trimmed(written);
  const char* const last = text.data() + text.size();
  double value = 0;
  const auto [end, error] = std::from_chars(text.data(), last, value);
  if (error == std::errc::result_out_of_range) throw InputError("too large or too small for a double");
  if (error != std::errc{}) throw InputError("not a number");
  if (!std::isfinite(value)) throw InputError("not a finite number");
  const std::string_view name = trimmed({end, static_cast<std::size_t>(last - end)});
  if (name.empty()) return value;
  if (expected.empty()) throw InputError("expected a plain number, found the unit " + shown(name));
  const Unit unit = parse_unit(name);
  if (unit.dimension != parse_unit(expected).dimension)
    throw InputError("the unit " + shown(name) + " has the wrong dimension, expected one like " +
                     std::string(expected));
  if (value == 0 || unit.power == 0) return value;

  const std::string_view number(text.data(), static_cast<std::size_t>(end - text.data()));
  const auto e = number.find_first_of("eE");
  const int exponent = e == number.npos ? 0 : std::stoi(std::string(number.substr(e + 1)));
  const std::string shifted = std::string(number.substr(0, e)) + 'e' + std::to_string(exponent + unit.power);
  if (std::from_chars(shifted.data(), shifted.data() + shifted.size(), value).ec != std::errc{})
    throw InputError("too large or too small for a double");
  return value;
}

/// Writes an SI value in the given unit, in the fewest digits that read back to the same bits: 0.021, "mm" -> "21 mm".
inline std::string format_quantity(double si, std::string_view unit) {
  if (!std::isfinite(si)) return std::isnan(si) ? "nan" : si > 0 ? "inf" : "-inf";
  auto decimal = detail::shortest(si);
  if (si != 0) decimal.exponent -= parse_unit(unit).power;
  return detail::layout(std::move(decimal)) + (unit.empty() ? "" : " " + std::string(unit));
}

/// Reads a whole number. Throws InputError for anything else.
inline int parse_integer(std::string_view written) {
  const std::string_view text = trimmed(written);
  int value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error == std::errc::result_out_of_range) throw InputError("too large for an integer");
  if (error != std::errc{} || end != text.data() + text.size()) throw InputError("not an integer");
  return value;
}

}  // namespace mpm::io
