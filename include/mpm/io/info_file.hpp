// SPDX-License-Identifier: MIT
#pragma once
#include <mpm/io/parameters.hpp>
#include <boost/property_tree/info_parser.hpp>
#include <boost/property_tree/ptree.hpp>
#include <filesystem>
#include <fstream>
#include <functional>
#include <ostream>
#include <sstream>
#include <string>
#include <vector>

// Parameters in Boost.PropertyTree's INFO format: nested braces, `;` starts a comment. Beyond plain INFO, a value runs
// to the end of its line and needs no quotes (`radius 21 mm`), where PropertyTree alone would take `mm` for a next key.
namespace mpm::io {

namespace detail {

/// One line with its values quoted and its comment dropped. Appends the line's number once for every key in it.
inline std::string quote_values(std::string_view line, int number, std::vector<int>& key_lines) {
  constexpr auto npos = std::string_view::npos;
  std::string quoted;
  bool key = true;
  for (std::size_t i = line.find_first_not_of(" \t\r\f\v"); i != npos && line[i] != ';';) {
    std::size_t end = i + 1;
    if (line[i] == '{' || line[i] == '}') {
      quoted += line[i];
      key = true;
    } else {
      if (line[i] == '"') {
        while (end < line.size() && line[end] != '"') end += line[end] == '\\' ? 2 : 1;
        end = std::min(end + 1, line.size());
        quoted += line.substr(i, end - i);
      } else {
        end = std::min(line.find_first_of(key ? " \t\r\f\v;{}\"" : ";{}\"", i), line.size());
        const std::string word(trimmed(line.substr(i, end - i)));
        quoted += key ? word : '"' + word + '"';
      }
      if (key) key_lines.push_back(number);
      key = !key;
    }
    quoted += ' ';
    i = line.find_first_not_of(" \t\r\f\v", end);
  }
  return quoted + '\n';
}

/// PropertyTree keeps the order of the file, so the n-th node of this walk is the n-th key of the file.
inline void flatten(const boost::property_tree::ptree& tree, const std::string& prefix, std::size_t& node,
                    const std::function<std::string(std::size_t)>& where, std::vector<Entry>& entries) {
  for (const auto& [name, child] : tree) {
    const std::string key = prefix + name;
    const std::string place = where(node++);
    if (child.empty() || !child.data().empty()) entries.push_back({key, child.data(), place});
    flatten(child, key + '.', node, where, entries);
  }
}

}  // namespace detail

/// Reads all entries of an INFO file, in its order. Throws InputError: missing or unreadable file, syntax error.
inline std::vector<Entry> read_info(const std::filesystem::path& path) {
  std::error_code ignored;
  std::ifstream file(path);
  if (!file || std::filesystem::is_directory(path, ignored))
    throw InputError("cannot read the file " + shown(path.string()) + ": check the path and its permissions");
  std::string line, text;
  std::vector<int> key_lines;
  for (int number = 1; std::getline(file, line); ++number) {
    if (number == 1 && line.starts_with("\xEF\xBB\xBF")) line.erase(0, 3);  // the mark some editors put first
    if (trimmed(line).starts_with('#'))
      throw InputError(path.string() + ':' + std::to_string(number) +
                       ": a line cannot start with #; comments start with ;");
    text += detail::quote_values(line, number, key_lines);
  }
  boost::property_tree::ptree tree;
  try {
    std::istringstream stream(text);
    boost::property_tree::read_info(stream, tree);
  } catch (const boost::property_tree::info_parser_error& error) {
    throw InputError(path.string() + ':' + std::to_string(error.line()) + ": " + error.message() +
                     "; check the braces and quotes up to here");
  }
  std::vector<Entry> entries;
  std::size_t nodes = 0;
  const auto where = [&](std::size_t node) {
    return path.string() + (node < key_lines.size() ? ':' + std::to_string(key_lines[node]) : "");
  };
  detail::flatten(tree, "", nodes, where, entries);
  if (nodes != key_lines.size())  // a string continued over lines: better no line than a wrong one
    for (auto& entry : entries) entry.where = path.string();
  return entries;
}

/// Writes every parameter that has a value, so that the file reads back to the same bits.
inline void write_info(std::ostream& out, const Parameters& parameters) {
  std::vector<std::string> open;
  const auto indent = [&] { return std::string(2 * open.size(), ' '); };
  for (const auto& parameter : parameters) {
    const std::string value = value_text(parameter);
    if (value.empty()) continue;
    std::vector<std::string> path;
    std::istringstream stream(parameter.name);
    for (std::string word; std::getline(stream, word, '.');) path.push_back(word);
    const auto common = static_cast<std::size_t>(
        std::mismatch(open.begin(), open.end(), path.begin(), path.end() - 1).first - open.begin());
    while (open.size() > common) {
      open.pop_back();
      out << indent() << "}\n";
    }
    for (std::size_t i = common; i + 1 < path.size(); ++i) {
      out << indent() << path[i] << " {\n";
      open.push_back(path[i]);
    }
    out << indent() << path.back() << " \"" << value << "\"  ; " << parameter.text << '\n';
  }
  while (!open.empty()) {
    open.pop_back();
    out << indent() << "}\n";
  }
}

}  // namespace mpm::io
