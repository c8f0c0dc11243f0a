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
      if ((name + unit).find_first_of(",\"\n") != std::string::npos)
        throw std::invalid_argument(file_.string() + ": column `" + name + "` [" + unit + "] cannot stand in a header");
      header += (header.empty() ? "" : ",") + name + " [" + unit + "]";
    }
    if (columns.empty()) throw std::invalid_argument(file_.string() + ": a table without columns");
    out_.open(file_, std::ios::binary | std::ios::trunc);
    write(header);
  }

  /// Appends one row. Throws std::invalid_argument if the values are not as many as the columns, std::runtime_error
  /// naming the file if it cannot be written.
  void row(std::span<const double> values) {
    if (values.size() != columns_)
      throw std::invalid_argument(file_.string() + ": " + std::to_string(values.size()) + " values for " +
                                  std::to_string(columns_) + " columns");
    std::string line;
    for (const double value : values) (line += line.empty() ? "" : ",") += number(value);
    write(line);
  }

 private:
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
