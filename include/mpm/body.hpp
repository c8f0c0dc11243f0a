// SPDX-License-Identifier: MIT
#pragma once
#include <mpm/columns.hpp>
#include <mpm/concepts/material.hpp>
#include <mpm/concepts/shape_function.hpp>
#include <mpm/concepts/space.hpp>
#include <mpm/error.hpp>
#include <mpm/lanes.hpp>
#include <mpm/spaces/plane_strain.hpp>
#include <Eigen/Core>
#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <sstream>
#include <string>

namespace mpm {

template <class S>
using Vector = Eigen::Matrix<typename S::Scalar, S::dimension, 1>;

/// A set of particles of one shape and one law. It names neither integrator nor neighbours, so a change of stage moves
/// it from one solver to the next.
///
/// Fields, one column each (SI; per metre of depth in plane strain): x position, v velocity, m mass, V volume, sigma
/// (or the pressure of a fluid), the law's history, and F where shape or law ask for it.
template <ShapeFunction ShapeT, Material MaterialT, Space SpaceT = PlaneStrain<>>
class Body {
 public:
  using Shape = ShapeT;
  using Law = MaterialT;
  using SpaceType = SpaceT;
  using Scalar = typename SpaceT::Scalar;
  using State = typename Law::template State<Scalar>;
  using Lane = LanesOf<Scalar>;
  static constexpr int dimension = SpaceT::dimension;
  static constexpr bool fluid = Fluid<Law>;
  static constexpr bool stores_F =
      needs_deformation_gradient<Law> || Shape::domain_motion == DomainMotion::deformation_gradient;
  static constexpr int stress_count = fluid ? 1 : int(SpaceT::stress_components.size());
  static constexpr int history_count = int(Law::history.size());
  static constexpr int F_count = stores_F ? int(SpaceT::gradient_components.size()) : 0;
  static_assert(
      requires { Shape::template bytes<SpaceT>; },
      "mpm::ShapeFunction: `bytes<Space>` is missing, what the shape stores a particle beside the body's fields");
  static_assert(
      !(fluid && dimension > 1 && tangles<Shape>),
      "mpm::Body: CPDI domains tangle in the flow of a gas; give the gas mpm::Ugimp or mpm::QuadraticBspline");
  static constexpr int column_count = 2 * dimension + 2 + stress_count + history_count + F_count;
  /// What one particle costs in memory, its share of the shape's own mesh included.
  static constexpr std::size_t bytes_per_particle = column_count * sizeof(Scalar) + Shape::template bytes<SpaceT>;

  static_assert(sizeof(State) == sizeof(Scalar) * ((fluid ? 1 : 6) + history_count),
                "Material::history must name every member of State<V> behind the stress or pressure, in order");

  std::string name = "body";
  Shape shape;
  Law law;
  double stress_work = 0;   ///< sum of V sigma : D dt since the start, J
  double viscous_work = 0;  ///< the part that the law's bulk viscosity took, to first order in dt

  Body() = default;
  Body(std::string body_name, Shape body_shape, Law body_law)
      : name(std::move(body_name)), shape(std::move(body_shape)), law(std::move(body_law)) {}

  /// The same particles in numbers of another type.
  template <class Other>
  requires(!std::is_same_v<Other, SpaceT>) explicit Body(const Body<Shape, Law, Other>& other)
      : name(other.name),
        shape(other.shape),
        law(other.law),
        stress_work(other.stress_work),
        viscous_work(other.viscous_work) {
    static_assert(Other::dimension == dimension && Other::hoop == SpaceT::hoop, "mpm::Body: the spaces differ");
    columns_.resize(other.size());
    for (int c = 0; c < column_count; ++c)
      std::transform(other.columns()[c], other.columns()[c] + other.size(), columns_[c],
                     [](auto value) { return Scalar(value); });
  }

  std::size_t size() const { return columns_.size(); }

  /// Appends a particle at rest or moving, in the law's initial state at relative volume J (mass = rho0 V / J). Throws
  /// Error on a volume, J or density that is not positive.
  void add(const Vector<SpaceT>& position, Scalar particle_volume, const Vector<SpaceT>& velocity, Scalar J = 1) {
    const std::size_t p = size();
    require_positive("volume", double(particle_volume));
    require_positive("relative volume", double(J));
    require_positive("density", double(law.density));
    columns_.resize(p + 1);
    for (int d = 0; d < dimension; ++d) x(d)[p] = position[d], v(d)[p] = velocity[d];
    mass()[p] = Scalar(law.density) * particle_volume / J;
    volume()[p] = particle_volume;
    store(p, law.template initial<Scalar>());
    if constexpr (stores_F) store_F(p, Tensor<Scalar>::identity());
  }

  Scalar* x(int d) { return columns_[d]; }
  const Scalar* x(int d) const { return columns_[d]; }
  Scalar* v(int d) { return columns_[dimension + d]; }
  const Scalar* v(int d) const { return columns_[dimension + d]; }
  Scalar* mass() { return columns_[2 * dimension]; }
  const Scalar* mass() const { return columns_[2 * dimension]; }
  Scalar* volume() { return columns_[2 * dimension + 1]; }
  const Scalar* volume() const { return columns_[2 * dimension + 1]; }
  /// Column of the law's history member `k` (order of Law::history).
  Scalar* history(int k) { return columns_[state_column + stress_count + k]; }
  const Scalar* history(int k) const { return columns_[state_column + stress_count + k]; }

  Vector<SpaceT> position(std::size_t p) const { return vector(p, 0); }
  Vector<SpaceT> velocity(std::size_t p) const { return vector(p, dimension); }
  /// Relative volume J = V / V0 = rho0 V / m.
  template <class V = Scalar>
  V relative_volume(std::size_t p) const {
    return V(Scalar(law.density)) * load<V>(volume() + p) / load<V>(mass() + p);
  }
  /// Edge of the cube of the particle's volume, m.
  template <class V = Scalar>
  V particle_size(std::size_t p) const {
    V box = load<V>(volume() + p);
    if constexpr (SpaceT::hoop) box = box / load<V>(x(0) + p);
    if constexpr (dimension == 1) return box;
    if constexpr (dimension == 2) return sqrt(box);
    if constexpr (dimension == 3) return cbrt(box);
  }

  /// The law's state of particle p, with the stress lifted to 3x3; with lanes for V, of the particles from p on.
  template <class V = Scalar>
  auto state(std::size_t p) const {
    std::array<V, full_stress + history_count> all{};
    for (int k = 0; k < stress_count; ++k) all[stress_slot(k)] = load<V>(columns_[state_column + k] + p);
    for (int k = 0; k < history_count; ++k) all[full_stress + k] = load<V>(history(k) + p);
    return std::bit_cast<typename Law::template State<V>>(all);
  }
  void store(std::size_t p, const State& s) { store_as<Scalar>(p, s); }
  template <class LaneState>
  void store(std::size_t p, const LaneState& s) {
    store_as<Lane>(p, s);
  }
  /// Cauchy stress of particle p, tension positive.
  template <class V = Scalar>
  SymmetricTensor<V> stress(std::size_t p) const {
    if constexpr (fluid) {
      return SymmetricTensor<V>::spherical(-load<V>(columns_[state_column] + p));
    } else {
      std::array<V, 6> all{};
      for (int k = 0; k < stress_count; ++k) all[stress_slot(k)] = load<V>(columns_[state_column + k] + p);
      return std::bit_cast<SymmetricTensor<V>>(all);
    }
  }
  template <class V = Scalar>
  Tensor<V> F(std::size_t p) const requires stores_F {
    auto all = std::bit_cast<std::array<V, 9>>(Tensor<V>::identity());
    for (int k = 0; k < F_count; ++k) all[SpaceT::gradient_components[k]] = load<V>(columns_[F_column + k] + p);
    return std::bit_cast<Tensor<V>>(all);
  }
  void store_F(std::size_t p, const Tensor<Scalar>& F) requires stores_F { store_F_as<Scalar>(p, F); }
  template <int N>
  void store_F(std::size_t p, const Tensor<Lanes<Scalar, N>>& F) requires stores_F {
    store_F_as<Lanes<Scalar, N>>(p, F);
  }

  /// Reorders the particles: particle i becomes the old particle order[i].
  void permute(std::span<const std::uint32_t> order) {
    columns_.permute(order, scratch_);
    shape.permute(order);
  }
  const Columns<Scalar, column_count>& columns() const { return columns_; }

 private:
  static constexpr int full_stress = fluid ? 1 : 6;
  static constexpr int state_column = 2 * dimension + 2;
  static constexpr int F_column = state_column + stress_count + history_count;

  template <class V>
  void store_as(std::size_t p, const typename Law::template State<V>& s) {
    const auto all = std::bit_cast<std::array<V, full_stress + history_count>>(s);
    for (int k = 0; k < stress_count; ++k) mpm::store(all[stress_slot(k)], columns_[state_column + k] + p);
    for (int k = 0; k < history_count; ++k) mpm::store(all[full_stress + k], history(k) + p);
  }
  template <class V>
  void store_F_as(std::size_t p, const Tensor<V>& F) {
    const auto all = std::bit_cast<std::array<V, 9>>(F);
    for (int k = 0; k < F_count; ++k) mpm::store(all[SpaceT::gradient_components[k]], columns_[F_column + k] + p);
  }
  void require_positive(const char* what, double value) const {
    if (value > 0 && std::isfinite(value)) return;
    std::ostringstream text;
    text << "body " << name << ": particle " << size() << " would have the " << what << ' ' << value
         << "; it must be positive";
    throw Error(text.str());
  }
  static constexpr int stress_slot(int k) { return fluid ? 0 : SpaceT::stress_components[k]; }
  Vector<SpaceT> vector(std::size_t p, int first) const {
    Vector<SpaceT> value;
    for (int d = 0; d < dimension; ++d) value[d] = columns_[first + d][p];
    return value;
  }

  Columns<Scalar, column_count> columns_;
  std::vector<Scalar> scratch_;
};

}  // namespace mpm
