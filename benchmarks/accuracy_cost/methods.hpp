// SPDX-License-Identifier: MIT
#pragma once
#include <mpm/mpm.hpp>
#include <type_traits>
#include "problem.hpp"

namespace accuracy_cost {

template <class Shape>
std::string shape_name() {
  if constexpr (std::is_same_v<Shape, mpm::Linear>) return "Linear";
  if constexpr (std::is_same_v<Shape, mpm::Ugimp>) return "Ugimp";
  if constexpr (std::is_same_v<Shape, mpm::MeanDilatation<mpm::Ugimp>>) return "Ugimp with mean dilatation";
  if constexpr (std::is_same_v<Shape, mpm::Cpgimp>) return "Cpgimp";
  if constexpr (std::is_same_v<Shape, mpm::QuadraticBspline>) return "QuadraticBspline";
  if constexpr (std::is_same_v<Shape, mpm::CubicBspline>) return "CubicBspline";
  if constexpr (std::is_same_v<Shape, mpm::Cpdi>) return "Cpdi";
  if constexpr (std::is_same_v<Shape, mpm::CpdiQuad>) return "CpdiQuad";
}

/// What stands beside shape, integrator and scalar.
struct Setting {
  int per_edge;  ///< particles an edge of a cell
  double cfl;    ///< share of the stable step
};

/// Makes the configurations of a problem: `run.template operator()<Shape, Integrator, Scalar>(options, integrator)`
/// returns the Outcome, and `variants` are the Options of each variant, which have `cells`, `per_edge` and `safety`.
template <class Options, class Run>
class Methods {
 public:
  /// The first setting is the usual one, the only one of a quick chart and of single precision.
  Methods(std::vector<Options> variants, std::vector<Setting> settings, Run run)
      : variants_(std::move(variants)), settings_(std::move(settings)), run_(std::move(run)) {}

  /// Every explicit integrator in double precision, and USL with FLIP in single. A full chart has, at the usual
  /// setting, the velocities beside the mean that particles can be strained with, too.
  template <class Shape>
  Methods& shape() {
    add<Shape, double>("USF", "FLIP", mpm::Usf{});
    add<Shape, double>("USL", "FLIP", mpm::Usl{});
    add<Shape, double>("MUSL", "FLIP", mpm::Musl{});
    for (const int k : {2, 4}) add<Shape, double>("USL", ordered("FMPM", k), mpm::Fmpm{.order = k});
    add<Shape, double>("USL", ordered("full-mass FLIP", 4), mpm::FullMassFlip{.order = 4});
    add<Shape, double>("USL", "APIC", mpm::Apic{});
    add<Shape, float>("USL", "FLIP", mpm::Usl{});
    add<Shape, double>("USL", "FMPM(4) v+", mpm::Fmpm{.order = 4, .strain_share = 0}, Part::full);
    add<Shape, double>("USL", "FMPM(4) v(k)", mpm::Fmpm{.order = 4, .strain_share = 1}, Part::full);
    add<Shape, double>("USL", "full-mass FLIP(4) v(k)", mpm::FullMassFlip{.order = 4, .strain_share = 1}, Part::full);
    return *this;
  }
  /// What of the chart an integrator is part of: all of it, or the full one at the usual setting.
  enum class Part { all, full };
  /// One integrator.
  template <class Shape, class Scalar, class Integrator>
  Methods& add(const std::string& integrator, const std::string& transfer, const Integrator& policy,
               Part part = Part::all) {
    constexpr bool single = std::is_same_v<Scalar, float>;
    for (std::size_t i = 0; i < (single || part == Part::full ? 1 : settings_.size()); ++i) {
      const Setting setting = settings_[i];
      made_.push_back(
          {{shape_name<Shape>(), integrator, transfer, single ? "float" : "double", setting.per_edge, setting.cfl},
           i == 0 && part == Part::all,
           [variants = variants_, run = run_, policy, setting](int cells, std::size_t variant) {
             Options options = variants.at(variant);
             options.cells = cells;
             options.per_edge = setting.per_edge;
             options.safety = setting.cfl;
             return run.template operator()<Shape, Integrator, Scalar>(options, policy);
           }});
    }
    return *this;
  }
  std::vector<Configuration> take() { return std::move(made_); }

 private:
  static std::string ordered(const std::string& transfer, int order) {
    return transfer + '(' + std::to_string(order) + ')';
  }

  std::vector<Options> variants_;
  std::vector<Setting> settings_;
  Run run_;
  std::vector<Configuration> made_;
};

}  // namespace accuracy_cost
