// SPDX-License-Identifier: MIT
#include "report.hpp"
#include "states.hpp"

namespace paper {
namespace {

struct Reading {
  const char *name, *text;
  double sigma_hel, D1, D2;
  bool tensile;
  double fracture_energy = 500;
};

constexpr Reading readings[] = {
    {"1200-d005-none", "1.2 GPa (.005, .7), JH-2 alone", 1.2e9, .005, .7, false},
    {"1200-d4-none", "1.2 GPa (.4, .9), JH-2 alone", 1.2e9, .4, .9, false},
    {"4500-d005-none", "4.5 GPa (.005, .7), JH-2 alone", 4.5e9, .005, .7, false},
    {"4500-d4-none", "4.5 GPa (.4, .9), JH-2 alone", 4.5e9, .4, .9, false},
    {"1200-d005-500", "1.2 GPa (.005, .7), 54 MPa, 500 J/m2", 1.2e9, .005, .7, true},
    {"4500-d4-500", "4.5 GPa (.4, .9), 54 MPa, 500 J/m2: the default", 4.5e9, .4, .9, true},
    {"4500-d4-1000", "4.5 GPa (.4, .9), 54 MPa, 1000 J/m2", 4.5e9, .4, .9, true, 1000},
};

blasting::Scene scene_of(const Reading& reading, const State& state) {
  auto scene = coarse_quarter(state, 1);
  auto& rock = scene.rock;
  rock.sigma_hel = reading.sigma_hel, rock.D1 = reading.D1, rock.D2 = reading.D2;
  rock.tensile.law = reading.tensile ? blasting::TensileLaw::rankine : blasting::TensileLaw::none;
  rock.tensile.fracture_energy = reading.fracture_energy;
  scene.relaxation.max_steps = 3000;  // rock that fails before the blast never comes to rest
  return scene;
}

std::string millimetres(const Blast& blast, const char* key) {
  return fixed(1e3 * blast.number(key), 0);
}

}  // namespace

void rock_readings(Report& report) {
  TableOf table{{"sigma_HEL (D1, D2), tensile law", "reach at 0 / 20 / 50 MPa, mm", "area, cm2", "k = .25: V / H, mm",
                 "k = 3: V / H, mm", "verdict"},
                {}};
  for (const auto& reading : readings) {
    std::vector<Blast> blasts;
    for (const State& state : {State{0, 0}, State{20, 20}, State{50, 50}, State{10, 40}, State{120, 40}})
      blasts.push_back(run({std::string("reading-") + reading.name + '-' + name_of(state), scene_of(reading, state)},
                           report.folder / "blasts"));
    std::string reach, area, verdict;
    for (int i = 0; i < 3; ++i) {
      reach += (i ? " / " : "") + millimetres(blasts[i], "crack.reach");
      area += (i ? " / " : "") + fixed(1e4 * blasts[i].number("crack.area"), 0);
    }
    const auto vertical = [&](int i) { return blasts[i].number("crack.along_y"); };
    const auto horizontal = [&](int i) { return blasts[i].number("crack.along_x"); };
    const auto add = [&](bool fails, const char* what) {
      if (fails) verdict += (verdict.empty() ? "" : "; ") + std::string(what);
    };
    add(!(blasts[0].number("crack.reach") > blasts[1].number("crack.reach") &&
          blasts[1].number("crack.reach") > blasts[2].number("crack.reach")),
        "reach does not fall");
    add(!(vertical(3) >= 1.25 * horizontal(3)), "k = .25 fails");
    add(!blasts[4].completed(), "the rock fails before the blast at k = 3");
    add(blasts[4].completed() && !(vertical(4) <= .6 * horizontal(4)), "k = 3 fails");
    const auto axes = [&](int i) {
      return blasts[i].completed()
                 ? millimetres(blasts[i], "crack.along_y") + " / " + millimetres(blasts[i], "crack.along_x")
                 : std::string("none");
    };
    table.rows.push_back({reading.text, reach, area, axes(3), axes(4), verdict.empty() ? "holds" : verdict});
  }
  report.page.section("What the paper's rock can mean", "readings");
  report.page.text(
      "Table 2 prints 4.5 GPa as the equivalent stress at the HEL, which its own equation of state makes the "
      "longitudinal one (the equivalent is 1.2 GPa), and no tensile law. "
      "Other readings, on quarters of the plane with 20 mm cells, seed 1:");
  report.page.table(table);
}

}  // namespace paper
