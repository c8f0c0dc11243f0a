// SPDX-License-Identifier: MIT
#pragma once
#include <mpm/io/units.hpp>
#include <functional>
#include <limits>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>
#include <variant>
#include <vector>

// A list of parameters is written down once, bound to the variables it describes. Reading, writing, the errors for
// unknown keys and the help text all run over that list.
namespace mpm::io {

/// The valid values of a number, in SI: min <= value <= max, or min < value where `open`.
struct Range {
  double min = -std::numeric_limits<double>::infinity();
  double max = std::numeric_limits<double>::infinity();
  bool open = false;
};

/// One of a few words, bound to a scoped enumeration whose enumerators are 0, 1, ... in the order of the words.
struct Choice {
  std::vector<std::string> words;
  std::function<std::size_t()> get;
  std::function<void(std::size_t)> set;

  template <class Enum>
  requires std::is_enum_v<Enum> Choice(Enum& variable, std::vector<std::string> choices)
      : words(std::move(choices)),
        get([&variable] { return static_cast<std::size_t>(variable); }),
        set([&variable](std::size_t i) { variable = static_cast<Enum>(i); }) {}
};

/// The variable behind a parameter. An optional one has no value until it is given; a list is written `a, b` or `none`.
using Slot = std::variant<double*, std::optional<double>*, std::vector<double>*, int*, bool*, Choice>;

/// One parameter: its dotted key, the variable that holds its value (and, before anything is read, its default), the
/// unit it is shown in (empty: dimensionless; the variable is in SI), its meaning, its valid values.
struct Parameter {
  std::string name;
  Slot slot;
  std::string unit;
  std::string text;
  Range range{};
};

using Parameters = std::vector<Parameter>;

/// A key and its value as somebody wrote them, and where: "scene.info:12" or "--set".
struct Entry {
  std::string key, value, where;
};

namespace detail {

template <class... F>
struct Overloaded : F... {
  using F::operator()...;
};
template <class... F>
Overloaded(F...) -> Overloaded<F...>;

inline std::string joined(const std::vector<std::string>& words, const char* separator) {
  std::string text;
  for (const auto& word : words) text += (text.empty() ? "" : separator) + word;
  return text;
}

inline std::vector<double> parse_list(std::string_view text, std::string_view unit) {
  std::vector<double> values;
  if (trimmed(text) == "none") return values;
  while (true) {
    const auto comma = text.find(',');
    values.push_back(parse_quantity(text.substr(0, comma), unit));
    if (comma == text.npos) return values;
    text.remove_prefix(comma + 1);
  }
}

inline bool parse_bool(std::string_view text) {
  if (text != "true" && text != "false") throw InputError("expected true or false");
  return text == "true";
}

inline std::size_t parse_choice(std::string_view text, const std::vector<std::string>& words) {
  const auto found = std::find(words.begin(), words.end(), text);
  if (found == words.end())
    throw InputError("expected one of " + joined(words, ", ") + "; the nearest is " + nearest(text, words));
  return static_cast<std::size_t>(found - words.begin());
}

inline void parse(const Parameter& parameter, std::string_view text) {
  std::visit(Overloaded{[&](double* v) { *v = parse_quantity(text, parameter.unit); },
                        [&](std::optional<double>* v) { *v = parse_quantity(text, parameter.unit); },
                        [&](std::vector<double>* v) { *v = parse_list(text, parameter.unit); },
                        [&](int* v) { *v = parse_integer(text); }, [&](bool* v) { *v = parse_bool(text); },
                        [&](const Choice& v) { v.set(parse_choice(text, v.words)); }},
             parameter.slot);
}

/// "what is wrong" becomes one line that names the place, the key and the value.
inline InputError located(const Entry& entry, const std::string& problem) {
  return InputError((entry.where.empty() ? "" : entry.where + ": ") + entry.key + " = " + shown(entry.value) + ": " +
                    problem);
}

}  // namespace detail

/// The numbers a parameter holds now, in SI: none for words, switches and an optional that was not given.
inline std::vector<double> numbers(const Parameter& parameter) {
  using Values = std::vector<double>;
  return std::visit(detail::Overloaded{[](const double* v) { return Values{*v}; },
                                       [](const std::optional<double>* v) { return *v ? Values{**v} : Values{}; },
                                       [](const std::vector<double>* v) { return *v; },
                                       [](const int* v) { return Values{static_cast<double>(*v)}; },
                                       [](const bool*) { return Values{}; }, [](const Choice&) { return Values{}; }},
                    parameter.slot);
}

/// The value a parameter holds now, as a scene file would write it; empty for an optional that was not given.
inline std::string value_text(const Parameter& parameter) {
  if (const auto* v = std::get_if<bool*>(&parameter.slot)) return **v ? "true" : "false";
  if (const auto* v = std::get_if<Choice>(&parameter.slot)) return v->words[v->get()];
  std::vector<std::string> values;
  for (const double value : numbers(parameter)) values.push_back(format_quantity(value, parameter.unit));
  if (values.empty() && std::holds_alternative<std::vector<double>*>(parameter.slot)) return "none";
  return detail::joined(values, ", ");
}

/// The valid values in words: "> 0 mm", "0 to 1", "petn | none"; empty where every value is valid.
inline std::string range_text(const Parameter& parameter) {
  if (const auto* v = std::get_if<Choice>(&parameter.slot)) return detail::joined(v->words, " | ");
  if (std::holds_alternative<bool*>(parameter.slot)) return "true | false";
  const auto [min, max, open] = parameter.range;
  const std::string low = format_quantity(min, parameter.unit), high = format_quantity(max, parameter.unit);
  if (std::isfinite(min) && std::isfinite(max)) return (open ? "above " : "") + low + " to " + high;
  if (std::isfinite(min)) return (open ? "> " : ">= ") + low;
  return std::isfinite(max) ? "<= " + high : "";
}

/// Throws InputError where a parameter holds a number that is not finite or not in its range.
inline void check_range(const Parameter& parameter) {
  for (const double value : numbers(parameter)) {
    if (!std::isfinite(value))
      throw detail::located({parameter.name, value_text(parameter), ""}, "not a finite number");
    const auto& [min, max, open] = parameter.range;
    if (value < min || value > max || (open && value == min))
      throw detail::located({parameter.name, value_text(parameter), ""},
                            "out of range, valid: " + range_text(parameter));
  }
}

/// Whether the keys of the list have a section of this name.
inline bool is_section(const Parameters& parameters, const std::string& name) {
  return std::any_of(parameters.begin(), parameters.end(),
                     [&](const Parameter& parameter) { return parameter.name.starts_with(name + '.'); });
}

/// Reads one entry into its parameter. Throws InputError: unknown key (naming the nearest one), no value, wrong type,
/// bad unit, out of range.
inline void assign(const Parameters& parameters, const Entry& entry) {
  std::vector<std::string> names;
  for (const auto& parameter : parameters) names.push_back(parameter.name);
  const auto found = std::find(names.begin(), names.end(), entry.key);
  if (found == names.end()) {
    const std::string where = entry.where.empty() ? "" : entry.where + ": ";
    if (is_section(parameters, entry.key))
      throw InputError(where + shown(entry.key) +
                       " is a section and has no value of its own, only keys between braces");
    throw InputError(where + "unknown key " + shown(entry.key) + ", the nearest known key is " +
                     nearest(entry.key, names));
  }
  const auto& parameter = parameters[static_cast<std::size_t>(found - names.begin())];
  const std::string_view value = trimmed(entry.value);
  if (value.empty()) throw detail::located(entry, "has no value");
  try {
    detail::parse(parameter, value);
  } catch (const InputError& error) {
    throw detail::located(entry, error.what());
  }
  try {
    check_range(parameter);
  } catch (const InputError&) {
    throw detail::located(entry, "out of range, valid: " + range_text(parameter));
  }
}

/// Reads all entries of one source; a section may be empty. Throws InputError as `assign` does, and for a key given
/// twice.
inline void assign_all(const Parameters& parameters, const std::vector<Entry>& entries) {
  std::set<std::string> seen;
  for (const auto& entry : entries) {
    if (entry.value.empty() && is_section(parameters, entry.key)) continue;
    if (!seen.insert(entry.key).second) throw detail::located(entry, "this key is given twice, keep one");
    assign(parameters, entry);
  }
}

}  // namespace mpm::io
