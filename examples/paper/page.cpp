// SPDX-License-Identifier: MIT
#include "page.hpp"
#include <mpm/io/text.hpp>

namespace paper {
namespace {

constexpr const char* style = R"(
body { font: 16px/1.5 system-ui, sans-serif; color: #1c2126; max-width: 76rem; margin: 2rem auto; padding: 0 1rem; }
h1 { font-size: 1.7rem; } h2 { font-size: 1.3rem; margin-top: 2.5rem; border-bottom: 1px solid #ccd2d8; }
nav a { margin-right: 1.2rem; } figure { margin: 1.2rem 0; } img { max-width: 100%; border: 1px solid #e2e6ea; }
figcaption { color: #4a535c; font-size: .92rem; } table { border-collapse: collapse; margin: 1rem 0; font-size: .92rem; }
th, td { border: 1px solid #d5dade; padding: .3rem .6rem; text-align: left; vertical-align: top; }
th { background: #f2f4f6; } .yes { color: #0a6b2d; font-weight: 600; } .no { color: #b3261e; font-weight: 600; }
)";

/// HTML marks that Markdown writes otherwise.
std::string as_markdown(std::string cell) {
  const auto replace = [&](const std::string& from, const std::string& to) {
    for (auto at = cell.find(from); at != cell.npos; at = cell.find(from, at)) cell.replace(at, from.size(), to);
  };
  replace("<span class=\"yes\">", ""), replace("<span class=\"no\">", "**"), replace("no</span>", "no**");
  replace("</span>", ""), replace("&lt;", "<"), replace("&gt;", ">");
  return cell;
}

}  // namespace

std::string TableOf::html() const {
  std::string text = "<table><tr>";
  for (const auto& cell : head) text += "<th>" + cell + "</th>";
  text += "</tr>\n";
  for (const auto& row : rows) {
    text += "<tr>";
    for (const auto& cell : row) text += "<td>" + cell + "</td>";
    text += "</tr>\n";
  }
  return text + "</table>\n";
}

std::string TableOf::markdown() const {
  std::string text = "|", rule = "\n|";
  for (const auto& cell : head) text += ' ' + cell + " |", rule += "---|";
  text += rule + '\n';
  for (const auto& row : rows) {
    text += '|';
    for (const auto& cell : row) text += ' ' + as_markdown(cell) + " |";
    text += '\n';
  }
  return text;
}

void Page::section(const std::string& title, const std::string& id) {
  contents_ += "<a href=\"#" + id + "\">" + title + "</a>\n";
  body_ += "<h2 id=\"" + id + "\">" + title + "</h2>\n";
}
void Page::text(const std::string& html) {
  body_ += "<p>" + html + "</p>\n";
}
void Page::table(const TableOf& table) {
  body_ += table.html();
}

void Page::figure(const std::filesystem::path& folder, const std::string& png, const std::string& caption) {
  const auto csv = std::filesystem::path(png).replace_extension(".csv");
  body_ += "<figure>";
  if (std::filesystem::exists(folder / png))
    body_ += "<a href=\"" + png + "\"><img src=\"" + png + "\" alt=\"" + png + "\"></a>";
  body_ += "<figcaption>" + caption;
  if (std::filesystem::exists(folder / csv)) body_ += " <a href=\"" + csv.string() + "\">Data</a>.";
  body_ += "</figcaption></figure>\n";
}

void Page::write(const std::filesystem::path& folder, const std::string& title, const std::string& head) const {
  mpm::io::replace_file(folder / "index.html",
                        "<!DOCTYPE html>\n<html lang=\"en\"><head><meta charset=\"utf-8\"><title>" + title +
                            "</title><style>" + style + "</style></head>\n<body><h1>" + title + "</h1>\n<nav>" +
                            contents_ + "</nav>\n" + head + body_ + "</body></html>\n");
}

}  // namespace paper
