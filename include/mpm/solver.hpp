// SPDX-License-Identifier: MIT
#pragma once
#include <mpm/boundaries/box.hpp>
#include <mpm/concepts/integrator.hpp>
#include <mpm/faults.hpp>
#include <mpm/passes/transfer.hpp>
#include <mpm/per_body.hpp>
#include <mpm/rest.hpp>
#include <limits>
#include <string>

namespace mpm {

namespace detail {
template <class List, class Integrator>
struct TransfersOf;
template <class Integrator, class... B>
struct TransfersOf<std::tuple<B...>, Integrator> {
  using Type = std::tuple<Transfer<B, Integrator>...>;
};
}  // namespace detail

/// The material point method: one background grid, any number of bodies, one shape function and one law a body, one
/// time integrator; a body force that may differ between particles. `step()` is its table of contents.
template <class Shape, class Material, Integrator IntegratorT, Space S = PlaneStrain<>,
          class BodyForceT = UniformBodyForce<S>>
class Solver {
 public:
  using Scalar = typename S::Scalar;
  using BodyList = Bodies<Shape, Material, S>;
  template <int I>
  using BodyAt = std::tuple_element_t<I, BodyList>;
  static constexpr StressUpdate stress_update = IntegratorT::stress_update;
  /// The integrator undoes the smoothing of the transfers.
  static constexpr bool refines = requires(IntegratorT i, Grid<S> g, void (*residual)(std::vector<Vector<S>>&)) {
    i.refine(g, std::int64_t{}, residual);
  };
  static_assert(
      requires(IntegratorT i, Grid<S> g, Scalar dt) { i.advance(g, dt); },
      "mpm::Integrator: `advance(grid, dt)` is missing, which Solver::step calls to move the nodes");

  Grid<S> grid;
  BodyList bodies;
  IntegratorT integrator{};
  Box<S> boundary;
  BodyForceT body_force{};           ///< b, m/s2
  Scalar safety = Scalar(0.8);       ///< share of the stable step that is taken
  Scalar step_floor = Scalar(1e-6);  ///< share of the first stable step; a shorter one stops the run
  double time = 0;                   ///< s
  std::int64_t steps = 0;

  /// Takes the grid and the bodies, in the order of the columns.
  template <class... B>
  explicit Solver(Grid<S> background, B... body) : grid(std::move(background)), bodies(std::move(body)...) {
    if constexpr (own_strain_velocity) grid.strain_velocity = grid.velocity;
    if constexpr (refines) smoothed_ = grid.velocity;
  }

  /// The body of a column. Particles may be added between steps; after any other change of theirs, or of their law,
  /// call `bodies_changed`.
  template <int I = 0>
  BodyAt<I>& body() {
    return std::get<I>(bodies);
  }

  /// One step, as long as is stable but no longer than `longest`; returns its length, s. Throws Error when a particle
  /// leaves the grid, a volume or a stress is no longer finite, or no stable step exists, or none above `step_floor`.
  Scalar step(double longest = std::numeric_limits<double>::max()) {
    locate_particles();        // particles ordered by block
    scatter<in_first_pass>();  // m_I = sum w m_p, v_I = sum w m_p v_p / m_I
    const Scalar dt = Scalar(std::min(longest, double(stable_step())));
    if constexpr (stress_update == StressUpdate::first) strain_first(dt);  // sigma before the forces it makes
    boundary.load(grid);                    // f_I = sum (-V sigma grad w + w m b) + tractions, held reactions
    constrain(grid.increment);              // walls, rollers, nodes beside blocks at rest
    const Scalar kick = next_kick(dt);      // from the middle of the last step to that of this one
    integrator.advance(grid, kick);         // v_I+ = v_I + kick f_I / m_I
    boundary.absorb(grid, kick);            // dashpots
    if constexpr (refines) refine_nodes();  // v_I+ sharpened
    gather(dt);                             // v_p += sum w (v_I+ - v_I); L = sum v_I (x) grad w, sigma, V; x_p
    convect_corners(dt);                    // CPDI2 domains ride the nodes
    rest_.wake(grid);                       // what the motion is about to reach
    time += dt;
    ++steps;
    return dt;
  }

  /// Steps until `end`, which is met exactly; calls `after(solver)` after each step.
  template <class F>
  void run(double end, const F& after) {
    while (time < end) {
      step(end - time);
      after(*this);
    }
  }
  void run(double end) {
    run(end, [](const Solver&) {});
  }

  /// To be called when particles were changed between two steps: places and stable step are then found anew.
  void bodies_changed() {
    for_each_body([](auto&, auto& transfer) { transfer.forget(); });
  }

  /// Nodal forces -V sigma grad w + w m b of the present state in grid.increment, boundaries not included.
  void internal_forces() {
    locate_particles();
    scatter<IntegratorT::keeps_node_velocity ? What::mass_and_forces : What::momentum_and_forces>();
  }
  /// Makes every quiet face carry the load that keeps the present state at rest.
  void hold_quiet_faces() {
    internal_forces();
    boundary.constrain(grid.increment, grid);
    boundary.hold(grid);
  }
  /// Lets the particles of body I rest wherever they are in balance, at no cost, until a node near them is faster than
  /// `speed`, m/s: the error is of that order times the impedance. Blocks with particles of other bodies, or with free
  /// edges of CPDI2 domains, do not rest. A load that sets in later on a face of the grid wakes nobody.
  template <int I = 0>
  void let_rest(Scalar speed) {
    static_assert(!IntegratorT::keeps_node_velocity, "mpm::Solver: a relaxation has to move what is to rest");
    internal_forces();
    boundary.load(grid);
    boundary.constrain(grid.increment, grid);
    const Scalar dt = stable_step();
    std::vector<char> holds(std::size_t(grid.block_count()), 0), stirs = holds;
    grid.for_each_active([&](int n) {
      if (dt * grid.increment[n].norm() > speed * grid.mass[n]) stirs[std::size_t(grid.block_of(n))] = 1;
    });
    for_each_body([&]<class B>(B& b, auto&) {
      const bool may_rest = static_cast<const void*>(&b) == static_cast<const void*>(&body<I>());
      for (std::size_t p = 0; p < b.size(); ++p) {
        const auto block = std::size_t(grid.block_at(b.position(p)));
        holds[block] = 1;
        if (!may_rest || !(b.velocity(p).norm() <= speed)) stirs[block] = 1;
      }
      if constexpr (requires { b.shape.surface; })
        for (const auto& edge : b.shape.surface)
          stirs[std::size_t(
              grid.block_at({Scalar(b.shape.corner[edge.first][0]), Scalar(b.shape.corner[edge.first][1])}))] = 1;
    });
    rest_.speed = speed;
    rest_.begin(grid, holds, stirs);
  }
  /// Norm over the nodes of sum abs(V sigma grad w) of the present state, the scale of the nodal forces, N.
  double force_scale() {
    locate_particles();
    std::vector<Scalar> scale(grid.size(), 0);
    for_each_body([&](auto& b, auto& transfer) { transfer.scatter_force_scale(b, grid, scale); });
    double sum = 0;
    for (Scalar s : scale) sum += double(s) * double(s);
    return std::sqrt(sum);
  }

  /// Calls f(body) for every body, in order.
  template <class F>
  void for_bodies(const F& f) {
    for_each_body([&](auto& b, auto&) { f(b); });
  }
  /// Calls f(columns) for every body with the columns that the integrator keeps for its particles, in order.
  template <class F>
  void for_particle_columns(const F& f) {
    for_each_body([&](auto&, auto& transfer) { f(transfer.columns()); });
  }

 private:
  template <class F>
  void for_each_body(const F& f) {
    [&]<std::size_t... I>(std::index_sequence<I...>) {
      (f(std::get<I>(bodies), std::get<I>(transfers_)), ...);
    }
    (std::make_index_sequence<std::tuple_size_v<BodyList>>());
  }

  void locate_particles() {
    clear_nodes();  // those of a block that is about to fall idle, too
    grid.deactivate_all();
    for_each_body([&](auto& b, auto& transfer) {
      if (steps == 0) check_policies(b, grid);
      if (const std::size_t p = first_unfit(b, grid, transfer.chunks_of(b.size())); p < b.size())
        fail_unfit(b, p, grid, now());
      transfer.locate(b, grid);
    });
    grid.sort_active();
    rest_.hold(grid, [&](const auto& f) {
      for_each_body([&](auto& b, auto& transfer) { transfer.for_each_resting_node(b, grid, f); });
    });
  }
  void clear_nodes() {
    grid.for_each_active([&](int n) {
      grid.mass[n] = 0;
      if constexpr (!IntegratorT::keeps_node_velocity) grid.velocity[n].setZero();
      grid.increment[n].setZero();
    });
  }
  /// What the first pass from the particles gives to the nodes: forces with it, unless the stress is yet to change.
  static constexpr What in_first_pass = IntegratorT::keeps_node_velocity       ? What::mass_and_forces
                                        : stress_update == StressUpdate::first ? What::momentum
                                                                               : What::momentum_and_forces;
  /// m_I, v_I (kept from the last step by an integrator that keeps node velocities), f_I.
  template <What what>
  void scatter() {
    for_each_body([&](auto& b, auto& transfer) {
      const std::size_t bad =
          transfer.template scatter<what, gives_mass<what>>(b, grid, grid.velocity, body_force, time);
      if (bad < b.size())
        fail_particle(b, bad, now(), "has a stress that is no finite number",
                      "lower `safety`, or look at the parameters of its law");
    });
    if constexpr (gives_momentum<what>) divide_by_mass(grid.velocity);
  }
  void divide_by_mass(std::vector<Vector<S>>& momentum) {
    grid.for_each_active([&](int n) {
      if (grid.mass[n] > 0) momentum[n] /= grid.mass[n];
    });
    constrain(momentum);
  }
  void constrain(std::vector<Vector<S>>& field) {
    boundary.constrain(field, grid);
    rest_.constrain(field);
  }
  void refine_nodes() {
    integrator.refine(grid, steps, [&](std::vector<Vector<S>>& field) { subtract_smoothed(field); });
  }
  /// field -= M^-1 S^T m S field: what is lost of a nodal field on its way to the particles and back.
  void subtract_smoothed(std::vector<Vector<S>>& field) {
    grid.for_each_active([&](int n) { smoothed_[n].setZero(); });
    for_each_body([&](auto& b, auto& transfer) { transfer.scatter_interpolated(b, grid, field, smoothed_); });
    divide_by_mass(smoothed_);
    grid.for_each_active([&](int n) { field[n] -= smoothed_[n]; });
  }
  /// MUSL: the particles' new momenta, back on the nodes.
  void remap_momentum() {
    grid.for_each_active([&](int n) { grid.mass[n] = 0, grid.strain_velocity[n].setZero(); });
    for_each_body([&](auto& b, auto& transfer) {
      transfer.template scatter<What::momentum>(b, grid, grid.strain_velocity, body_force, time);
    });
    divide_by_mass(grid.strain_velocity);
  }
  static constexpr bool blends = !IntegratorT::keeps_node_velocity;
  /// Particles are strained, and corners moved, by a field of their own: the remapped one (MUSL), or the one an
  /// integrator that refines has made. Otherwise by the nodes' velocity, which is v_I before they are advanced and v_I+
  /// after.
  static constexpr bool own_strain_velocity = stress_update == StressUpdate::modified_last || refines;

  /// Strains with the velocities before the forces act. Domains that follow F have then changed: the nodes are gathered
  /// anew, since mass and force must see one set of weights, or momentum is lost.
  void strain_first(Scalar dt) {
    update<false, Strained::by_first, false>(dt);
    bool domains_changed = false;
    for_each_body(
        [&]<class B>(B&, auto&) { domains_changed |= B::Shape::domain_motion == DomainMotion::deformation_gradient; });
    if (!domains_changed) return scatter<What::forces>();
    locate_particles();
    scatter<What::momentum_and_forces>();
  }
  /// The particles' way back. One pass does it all, unless the velocities must be known before the strain (MUSL, and
  /// integrators that refine), or the strain before the forces (USF).
  void gather(Scalar dt) {
    if constexpr (stress_update == StressUpdate::first) {
      update<blends, Strained::none, true>(dt);
    } else if constexpr (own_strain_velocity) {
      update<blends, Strained::none, false>(dt);
      if constexpr (stress_update == StressUpdate::modified_last) remap_momentum();
      update<false, Strained::by_second, true>(dt);
    } else {
      update<blends, Strained::by_first, true>(dt);
    }
  }
  template <bool Blend, Strained strained, bool Move>
  void update(Scalar dt) {
    for_each_body([&](auto& b, auto& transfer) {
      const std::size_t bad = transfer.template update<Blend, strained, Move>(b, grid, integrator, Scalar(time), dt);
      if (bad < b.size())
        fail_particle(b, bad, now(), "has a volume or stress that is no longer a finite number",
                      "lower `safety`, or refine the grid there");
    });
  }
  void convect_corners(Scalar dt) {
    for_each_body([&](auto& b, auto& transfer) {
      constexpr Strained strained = own_strain_velocity ? Strained::by_second : Strained::by_first;
      if (const std::size_t p = transfer.template convect<strained>(b, dt); p < b.size())
        fail_particle(b, p, now(), "has a domain turned inside out",
                      "refine the grid there, lower `safety`, or take a shape that cannot invert, such as mpm::Cpdi");
    });
  }
  Scalar stable_step() {
    if (steps % IntegratorT::step_interval == 0) {
      stable_ = std::numeric_limits<Scalar>::max();
      for_each_body([&](auto& b, auto& transfer) { stable_ = std::min(stable_, transfer.stable_step(b, grid)); });
      if (!(stable_ > 0)) {
        for_each_body([&](auto& b, auto&) { blame_stiffness(b, now()); });
        throw Error("no particle allows a stable step, in step " + std::to_string(steps));
      }
      if (steps == 0) first_stable_ = stable_;
      if (stable_ < step_floor * first_stable_) blame_shortest();
    }
    if constexpr (requires { integrator.step_factor(); }) {
      return safety * Scalar(integrator.step_factor()) * stable_;
    } else {
      return safety * stable_;
    }
  }

  /// Velocities stand in the middle between two states of the stress, so that forces act from the middle of the last
  /// step to that of this one: leapfrog with steps that differ. Where a step is much shorter than the last, by no more
  /// than the safety leaves room for; later steps make up for it. USF does not know the step that its velocities are
  /// for; there it is `dt`.
  Scalar next_kick(Scalar dt) {
    if (stress_update == StressUpdate::first) return dt;
    if (steps == 0) behind_ = dt / 2;
    const Scalar kick = std::min(behind_ + dt / 2, dt / std::sqrt(std::min(safety, Scalar(1))));
    behind_ += dt - kick;
    return kick;
  }

  Moment now() const { return {steps, time}; }
  /// Throws Error on the particle that allows the shortest step.
  void blame_shortest() {
    Scalar shortest = std::numeric_limits<Scalar>::max();
    for_each_body([&](auto& b, auto&) {
      for (std::size_t p = 0; p < b.size(); ++p) shortest = std::min(shortest, mpm::stable_step(b, p, grid));
    });
    for_each_body([&](auto& b, auto&) {
      for (std::size_t p = 0; p < b.size(); ++p)
        if (mpm::stable_step(b, p, grid) <= shortest) fail_short(b, p, grid, shortest, step_floor, now());
    });
  }

  typename detail::TransfersOf<BodyList, IntegratorT>::Type transfers_;
  Rest<S> rest_;
  std::vector<Vector<S>> smoothed_;
  Scalar stable_ = 0, first_stable_ = 0;
  Scalar behind_ = 0;  ///< by how much the velocities are older than the stresses, s
};

}  // namespace mpm
