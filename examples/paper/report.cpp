// SPDX-License-Identifier: MIT
#include "report.hpp"
#include <mpm/io/text.hpp>

namespace paper {
namespace {

std::string mark(bool holds) {
  return holds ? "<span class=\"yes\">yes</span>" : "<span class=\"no\">no</span>";
}

TableOf claims_of(const std::vector<Finding>& findings) {
  TableOf table{{"Claim", "Found", "Holds", "Coarse quarters, seeds 1, 2, 3"}, {}};
  for (const auto& finding : findings) {
    std::string by_seed;
    for (const bool holds : finding.by_seed) by_seed += (by_seed.empty() ? "" : ", ") + mark(holds);
    table.rows.push_back({finding.claim, finding.measured, mark(finding.holds), by_seed});
  }
  return table;
}

}  // namespace

void Report::write() const {
  const auto claims = claims_of(findings);
  page.write(folder, std::string("Rock blasting in deep ground") + (quick ? " (quick: cells of 20 mm)" : ""),
             "<p>The figures and statements of Xiao et al. 2024 (Processes 12, 1048), made again, and what goes beyond "
             "them: each statement, what was found, and whether it holds in this run. Those on the twelve blasts are "
             "judged again on quarters of the plane with cells of 20 mm, for three seeds of the scatter of the rock's "
             "strength.</p>\n" +
                 claims.html());
  mpm::io::replace_file(folder / "claims.md", claims.markdown() + '\n' + states.markdown());
}

}  // namespace paper
