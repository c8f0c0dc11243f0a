// SPDX-License-Identifier: MIT
#pragma once
#include <filesystem>
#include <string>
#include <vector>

namespace paper {

/// A table, for the page and for Markdown. Cells are HTML.
struct TableOf {
  std::vector<std::string> head{};
  std::vector<std::vector<std::string>> rows{};

  std::string html() const;
  std::string markdown() const;
};

/// The report: one HTML file that needs nothing but the files beside it.
class Page {
 public:
  void section(const std::string& title, const std::string& id);
  void text(const std::string& html);
  void table(const TableOf& table);
  /// A picture of the report's folder, with the CSV of its curves where there is one.
  void figure(const std::filesystem::path& folder, const std::string& png, const std::string& caption);
  /// Puts index.html into the folder: `head`, which is HTML, before the sections.
  void write(const std::filesystem::path& folder, const std::string& title, const std::string& head) const;

 private:
  std::string contents_, body_;
};

}  // namespace paper
