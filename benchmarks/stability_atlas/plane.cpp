// SPDX-License-Identifier: MIT
#include <accuracy_cost/methods.hpp>
#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include "sheets.hpp"

// Motions of a block in the plane that no stress resists, or that is rigid, and a gas.
namespace mpm::atlas {
namespace {

using S = PlaneStrain<>;
constexpr double infinity = std::numeric_limits<double>::infinity();

/// A law whose particles carry where they started.
struct Marked : Hypoelastic {
  template <class V>
  struct State : Hypoelastic::State<V> {
    V X{}, Y{};
  };
  static constexpr std::array history{"X", "Y"};
  template <class V>
  State<V> initial() const {
    return {Hypoelastic::initial<V>(), V(0), V(0)};
  }
};

template <class Shape, class Integrator>
using BlockSolver = Solver<Shape, Marked, Integrator, S>;

/// A block of width x height unit cells about `centre`, 2 particles an edge, that moves with `velocity(x - centre)`.
template <class Shape, class Integrator, class F>
BlockSolver<Shape, Integrator> block(const Vector<S>& size, const Vector<S>& centre, const std::array<int, 2>& cells,
                                     double young, const F& velocity) {
  Body<Shape, Marked, S> body{"block", {}, {{.density = 1, .young = young, .poisson = 0}}};
  fill(body, centre - size / 2, centre + size / 2, .5);
  for (std::size_t p = 0; p < body.size(); ++p) {
    const Vector<S> X = body.position(p) - centre, v = velocity(X);
    for (int d = 0; d < 2; ++d) body.v(d)[p] = v[d], body.history(d)[p] = X[d];
  }
  return BlockSolver<Shape, Integrator>{Grid<S>{{0, 0}, 1, cells}, std::move(body)};
}

/// Steps to `end` and calls after(solver) about `samples` times; false if the run stops before.
template <class SolverT, class F>
bool run_until(SolverT& solver, double end, int samples, const F& after) {
  try {
    for (int k = 1; k <= samples; ++k) {
      solver.run(end * k / samples);
      after();
    }
  } catch (const Error&) {
    return false;
  }
  return true;
}

/// Root mean square distance of the particles from where `exact(X)` puts them, relative to the centre, in cells.
template <class Body, class F>
double misplaced(const Body& body, const Vector<S>& centre, const F& exact) {
  double sum = 0;
  for (std::size_t p = 0; p < body.size(); ++p) {
    const Vector<S> X{body.history(0)[p], body.history(1)[p]};
    sum += (body.position(p) - centre - exact(X)).squaredNorm();
  }
  return std::sqrt(sum / double(body.size()));
}

/// Angle by which a block has turned about its centre, the best in the sense of least squares, -pi to pi.
template <class Body>
double turned_by(const Body& body, const Vector<S>& centre) {
  double sine = 0, cosine = 0;
  for (std::size_t p = 0; p < body.size(); ++p) {
    const Vector<S> x = body.position(p) - centre;
    const double X = body.history(0)[p], Y = body.history(1)[p];
    sine += X * x[1] - Y * x[0], cosine += X * x[0] + Y * x[1];
  }
  return std::atan2(sine, cosine);
}

template <class F>
void for_shapes(const F& f) {
  f.template operator()<Linear>();
  f.template operator()<Ugimp>();
  f.template operator()<Cpgimp>();
  f.template operator()<Cpdi>();
  f.template operator()<CpdiQuad>();
  f.template operator()<QuadraticBspline>();
  f.template operator()<CubicBspline>();
}

/// Largest distance between the ends of neighbours in a row, in the length of their domains.
template <class Body>
double widest_gap(const Body& body) {
  struct End {
    double Y, X, left, right;
  };
  std::vector<End> ends;
  for (std::size_t p = 0; p < body.size(); ++p) {
    double left = 0, right = 0;
    if constexpr (requires { body.shape.quad; }) {
      const auto& q = body.shape.quad[p];
      const auto x = [&](int c) { return body.shape.corner[q[std::size_t(c)]][0]; };
      left = (x(0) + x(3)) / 2, right = (x(1) + x(2)) / 2;
    } else {
      const double reach = std::min(1.5, body.shape.reach(body, p, Grid<S>{{0, 0}, 1, {1, 1}})[0]);
      left = body.x(0)[p] - reach, right = body.x(0)[p] + reach;
      if constexpr (std::is_same_v<typename Body::Shape, Cpdi>) {
        left = body.x(0)[p] - body.F(p).xx * body.shape.half_size[0];
        right = body.x(0)[p] + body.F(p).xx * body.shape.half_size[0];
      }
    }
    ends.push_back({body.history(1)[p], body.history(0)[p], left, right});
  }
  std::ranges::sort(ends, [](const End& a, const End& b) { return a.Y != b.Y ? a.Y < b.Y : a.X < b.X; });
  double widest = 0;
  for (std::size_t k = 1; k < ends.size(); ++k)
    if (ends[k].Y == ends[k - 1].Y)
      widest = std::max(widest, (ends[k].left - ends[k - 1].right) / (ends[k].right - ends[k].left));
  return widest;
}

}  // namespace

Sheet shear_flow(bool quick) {
  Sheet sheet{"shear", "shear to 10"};
  sheet.title = "A block without stiffness in simple shear: where its particles are";
  sheet.x_label = "shear";
  sheet.y_label = "error of the displacement, %";
  sheet.at = "shear ", sheet.limit = .2, sheet.percent = 100;
  for_shapes([&]<class Shape>() {
    const std::string name = accuracy_cost::shape_name<Shape>() + " USL";
    const Vector<S> centre{32, 6};
    auto solver = block<Shape, Usl>({6, 6}, centre, {64, 12}, 1e-9, [](const Vector<S>& X) {
      return Vector<S>{X[1], 0};
    });
    const bool stood = run_until(solver, 10, quick ? 10 : 40, [&] {
      const double shear = solver.time, rms_height = std::sqrt(143 / 48.);  // of twelve rows, half a cell each
      const double error = misplaced(solver.body(), centre, [&](const Vector<S>& X) {
        return Vector<S>{X[0] + shear * X[1], X[1]};
      });
      sheet.points.push_back({name, shear, error / (shear * rms_height)});
    });
    if (!stood) sheet.points.push_back({name, solver.time, infinity});
  });
  return sheet;
}

Sheet spin(bool quick) {
  Sheet sheet{"spin", "two turns"};
  sheet.title = "A stiff block of 4 cells turns twice, its rim at .02 c: what its shape has lost";
  sheet.x_label = "angle, degrees";
  sheet.y_label = "rms distance from the turned block, cells";
  sheet.at = "degrees ", sheet.limit = .1;
  const auto add = [&]<class Shape>(const std::string& name, const auto& integrator) {
    constexpr double w = .02 / 2.83;
    const Vector<S> centre{5.3, 5.2};
    auto solver =
        block<Shape, std::remove_cvref_t<decltype(integrator)>>({4, 4}, centre, {11, 11}, 1, [](const Vector<S>& X) {
          return Vector<S>{-w * X[1], w * X[0]};
        });
    solver.integrator = integrator;
    const bool stood = run_until(solver, 4 * std::numbers::pi / w, quick ? 8 : 24, [&] {
      const double a = turned_by(solver.body(), centre), c = std::cos(a), s = std::sin(a);
      sheet.points.push_back(
          {name, w * solver.time * 180 / std::numbers::pi, misplaced(solver.body(), centre, [&](const auto& X) {
             return Vector<S>{c * X[0] - s * X[1], s * X[0] + c * X[1]};
           })});
    });
    if (!stood) sheet.points.push_back({name, w * solver.time * 180 / std::numbers::pi, infinity});
  };
  for_shapes(
      [&]<class Shape>() { add.template operator()<Shape>(accuracy_cost::shape_name<Shape>() + " USL", Usl{}); });
  add.operator()<Cpgimp>("Cpgimp MUSL", Musl{});
  add.operator()<Cpgimp>("Cpgimp MUSL PIC", Musl{.flip = 0});
  add.operator()<Cpgimp>("Cpgimp FMPM(2)", Fmpm{.order = 2});
  add.operator()<Cpgimp>("Cpgimp APIC", Apic{});
  return sheet;
}

Sheet over_stretch(bool quick) {
  Sheet sheet{"over_stretch", "domains part when stretched to 20"};
  sheet.title = "A strip without stiffness drawn out: widest gap between neighbours";
  sheet.x_label = "stretch";
  sheet.y_label = "widest gap, of a domain's length";
  sheet.at = "stretch ", sheet.limit = .5;
  const auto add = [&]<class Shape>() {
    const std::string name = accuracy_cost::shape_name<Shape>() + " USL";
    const Vector<S> centre{46.3, 3.2};
    auto solver = block<Shape, Usl>({4, 2}, centre, {92, 7}, 1e-9, [](const Vector<S>& X) {
      return Vector<S>{X[0], 0};
    });
    const bool stood = run_until(solver, 19, quick ? 19 : 76, [&] {
      sheet.points.push_back({name, 1 + solver.time, std::max(1e-6, widest_gap(solver.body()))});
    });
    if (!stood) sheet.points.push_back({name, 1 + solver.time, infinity});
  };
  add.operator()<Ugimp>();
  add.operator()<Cpgimp>();
  add.operator()<Cpdi>();
  add.operator()<CpdiQuad>();
  return sheet;
}

Sheet gas_in_a_box(bool quick) {
  Sheet sheet{"gas", "gas"};
  sheet.title = "Air in a closed box, a quarter of it at 20 times the pressure";
  sheet.x_label = "time, in crossings of the box by sound";
  sheet.y_label = "change of energy, %";
  sheet.at = "crossing ", sheet.limit = .1, sheet.percent = 100;
  for (const char* method : {"Cpdi MUSL", "CpdiQuad MUSL"}) sheet.refused[method] = "refused by the compiler";
  const auto add = [&]<class Shape>() {
    const std::string name = accuracy_cost::shape_name<Shape>() + " MUSL";
    Body<Shape, PolynomialEos, S> gas{"gas", {}, {.density = 1, .c4 = .4, .c5 = .4, .initial_energy = 2.5}};
    fill(gas, {0, 0}, {10, 10}, .5);
    double start = 0;
    for (std::size_t p = 0; p < gas.size(); ++p) {
      auto state = gas.state(p);
      if (gas.x(0)[p] < 5 && gas.x(1)[p] < 5) state.energy *= 20, state.pressure *= 20;
      start += gas.volume()[p] * state.energy;
      gas.store(p, state);
    }
    Solver<Shape, PolynomialEos, Musl, S> solver{Grid<S>{{0, 0}, 1, {10, 10}}, std::move(gas)};
    for (const int axis : {0, 1})
      for (const int side : {0, 1}) solver.boundary.face(axis, side) = Rollers<S>{};
    const double crossing = 10 / std::sqrt(1.4);
    const bool stood = run_until(solver, 10 * crossing, quick ? 10 : 40, [&] {
      const auto& body = solver.body();
      double energy = kinetic_energy(body);
      for (std::size_t p = 0; p < body.size(); ++p) energy += body.mass()[p] / body.law.density * body.state(p).energy;
      sheet.points.push_back({name, solver.time / crossing, std::max(1e-6, std::abs(energy / start - 1))});
    });
    if (!stood) sheet.points.push_back({name, solver.time / crossing, infinity});
  };
  add.operator()<Linear>();
  add.operator()<Ugimp>();
  add.operator()<Cpgimp>();
  add.operator()<QuadraticBspline>();
  add.operator()<CubicBspline>();
  return sheet;
}

}  // namespace mpm::atlas
