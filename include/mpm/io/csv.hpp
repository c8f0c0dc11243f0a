// SPDX-License-Identifier: MIT
#pragma once
#include <mpm/io/text.hpp>
#include <cstddef>
#include <filesystem>
#include <fstream>
#include <span>
#include <stdexcept>
#include <string>
#include <vector>

namespace mpm::io {

/// One column of a table: what it holds and in which unit ("1" for a pure number). Neither may hold a comma.
struct Column {
  std::string name{};
  std::string unit{};
};

/// A table that grows by a row at a time, as comma-separated values under one header line `time [s],kinetic [J/m],...`.
/// Each row is handed to the system whole, so that a killed run leaves whole lines. Numbers read back to the bit.
class CsvWriter {
 public:
  /// Starts the file afresh. Throws std::runtime_error naming the file if it cannot be written, std::invalid_argument
  /// if there is no column or a comma in one.
  CsvWriter(std::filesystem::path file, const std::vector<Column>& columns)
      : file_(std::move(file)), columns_(columns.size()) {
    std::string header;
    for (const auto& [name, unit] : columns) {
      if (!plain(name + unit))
        throw std::invalid_argument(file_.string() + ": column `" + name + "` [" + unit + "] cannot stand in a header");
      header += (header.empty() ? "" : ",") + name + " [" + unit + "]";
    }
    if (columns.empty()) throw std::invalid_argument(file_.string() + ": a table without columns");
    out_.open(file_, std::ios::binary | std::ios::trunc);
    write(header);
  }

  /// Appends one row. Throws std::invalid_argument if the cells are not as many as the columns or cannot stand in a
  /// table, std::runtime_error naming the file if it cannot be written.
  void row(std::span<const std::string> cells) {
    if (cells.size() != columns_)
      throw std::invalid_argument(file_.string() + ": " + std::to_string(cells.size()) + " values for " +
                                  std::to_string(columns_) + " columns");
    std::string line;
    for (const std::string& cell : cells) {
      if (!plain(cell)) throw std::invalid_argument(file_.string() + ": `" + cell + "` cannot stand in a table");
      line += (line.empty() ? "" : ",") + cell;
    }
    write(line);
  }
  void row(std::span<const double> values) {
    std::vector<std::string> cells;
    for (const double value : values) cells.push_back(number(value));
    row(cells);
  }

 private:
  static bool plain(const std::string& text) { return text.find_first_of(",\"\n") == std::string::npos; }
  void write(std::string line) {
    line += '\n';
    out_.write(line.data(), static_cast<std::streamsize>(line.size())).flush();
    if (!out_) throw std::runtime_error(file_.string() + ": cannot be written");
  }

  std::filesystem::path file_;
  std::size_t columns_;
  std::ofstream out_;
};

}  // namespace mpm::io
