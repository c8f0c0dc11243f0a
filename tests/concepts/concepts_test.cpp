// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>
#include <mpm/materials/presets.hpp>
#include <mpm/mpm.hpp>
#include <array>
#include <vector>

// Each concept, held from both sides: what is one, and what is none for the lack of a single thing. And what a particle
// costs. All of it is known when this file has compiled.
namespace {

using namespace mpm;

// Space -------------------------------------------------------------------------------------------------------------
static_assert(Space<PlaneStrain<>> && Space<PlaneStrain<float>> && Space<Uniaxial<>> && Space<Radial<>> &&
              Space<Axisymmetric<float>> && Space<Spatial<>>);
static_assert(!Space<double> && !Space<PlaneStrain<int>>);
struct SpaceThatHidesItsStresses {
  using Scalar = double;
  static constexpr int dimension = 2;
  [[maybe_unused]] static constexpr bool hoop = false;
  [[maybe_unused]] static constexpr std::array gradient_components{0, 1, 3, 4};
};
static_assert(!Space<SpaceThatHidesItsStresses>);

// Shape function ----------------------------------------------------------------------------------------------------
static_assert(ShapeFunction<Linear> && ShapeFunction<Ugimp> && ShapeFunction<Cpgimp> && ShapeFunction<Cpdi> &&
              ShapeFunction<CpdiQuad>);
struct ShapeThatDoesNotSayHowItMoves {
  void permute(std::span<const std::uint32_t>) {}
};
struct ShapeThatLosesItsParticles {
  static constexpr DomainMotion domain_motion = DomainMotion::rigid;
};
struct ShapeWithoutDefault : Linear {
  explicit ShapeWithoutDefault(double) {}
};
static_assert(!ShapeFunction<ShapeThatDoesNotSayHowItMoves> && !ShapeFunction<ShapeThatLosesItsParticles> &&
              !ShapeFunction<ShapeWithoutDefault> && !ShapeFunction<Hypoelastic>);

// Material ----------------------------------------------------------------------------------------------------------
static_assert(Material<Hypoelastic> && Material<NeoHookean> && Material<JohnsonHolmquist2> &&
              Material<WithTensileLaw<JohnsonHolmquist2>> && Material<JonesWilkinsLee> && Material<PolynomialEos>);
static_assert(Fluid<JonesWilkinsLee> && Fluid<PolynomialEos> && !Fluid<Hypoelastic> && !Fluid<JohnsonHolmquist2>);
static_assert(needs_deformation_gradient<NeoHookean> && !needs_deformation_gradient<Hypoelastic>);
struct LawThatIsNoAggregate : Hypoelastic {
  LawThatIsNoAggregate() {}
};
struct LawWithoutDensity {
  template <class V>
  using State = Hypoelastic::State<V>;
  [[maybe_unused]] static constexpr std::array<const char*, 0> history{};
  template <class V>
  State<V> initial() const {
    return {};
  }
  template <class V>
  void update(State<V>&, const Increment<V>&) const {}
  template <class V>
  Moduli<V> tangent(const State<V>&, const V&) const {
    return {};
  }
};
struct LawOfOneModulus : Hypoelastic {
  template <class V>
  V tangent(const State<V>&, const V&) const {
    return V(1);
  }
};
static_assert(!Material<LawThatIsNoAggregate> && !Material<LawWithoutDensity> && !Material<LawOfOneModulus> &&
              !Material<Linear>);

// Integrator --------------------------------------------------------------------------------------------------------
static_assert(Integrator<Usf> && Integrator<Usl> && Integrator<Musl> && Integrator<DynamicRelaxation<>> &&
              Integrator<DynamicRelaxation<Damping::fixed>> && Integrator<Fmpm> && Integrator<FullMassFlip> &&
              Integrator<Apic>);
static_assert(particle_columns<Apic, Spatial<>> == 9 && particle_columns<Apic, Uniaxial<>> == 1 &&
              particle_columns<Usl, Spatial<>> == 0);
struct IntegratorWithoutParticleVelocity {
  static constexpr StressUpdate stress_update = StressUpdate::last;
  [[maybe_unused]] static constexpr bool keeps_node_velocity = false;
  [[maybe_unused]] static constexpr int step_interval = 1;
};
struct IntegratorWithoutStressUpdate {
  [[maybe_unused]] static constexpr bool keeps_node_velocity = false;
  [[maybe_unused]] static constexpr int step_interval = 1;
  double particle_velocity(double, double v, double) const { return v; }
};
static_assert(!Integrator<IntegratorWithoutParticleVelocity> && !Integrator<IntegratorWithoutStressUpdate> &&
              !Integrator<Linear>);

// Body force --------------------------------------------------------------------------------------------------------
using Rock = Body<Ugimp, Hypoelastic>;
struct ForceWithoutTime {
  Vector<PlaneStrain<>> operator()(const Rock&, std::size_t) const { return {0, 0}; }
};
struct ForceAlongOneAxis {
  double operator()(const Rock&, std::size_t, double) const { return 0; }
};
static_assert(BodyForce<UniformBodyForce<PlaneStrain<>>, Rock> && !BodyForce<ForceWithoutTime, Rock> &&
              !BodyForce<ForceAlongOneAxis, Rock>);

// Boundary condition ------------------------------------------------------------------------------------------------
template <class S>
constexpr bool all_boundaries =
    BoundaryCondition<Free<S>, S>&& BoundaryCondition<Rollers<S>, S>&& BoundaryCondition<Fixed<S>, S>&&
        BoundaryCondition<Traction<S>, S>&& BoundaryCondition<Quiet<S>, S>&& BoundaryCondition<ViscousSpring<S>, S>;
static_assert(all_boundaries<PlaneStrain<>> && all_boundaries<Uniaxial<float>> && all_boundaries<Spatial<>> &&
              all_boundaries<Radial<>> && all_boundaries<Axisymmetric<>>);
struct BoundaryThatHidesItsWork {
  void load(Grid<PlaneStrain<>>&, int, int) const {}
  void constrain(std::vector<Vector<PlaneStrain<>>>&, const Grid<PlaneStrain<>>&, int, int) const {}
  void absorb(Grid<PlaneStrain<>>&, int, int, double) const {}
};
static_assert(!BoundaryCondition<BoundaryThatHidesItsWork, PlaneStrain<>>);
static_assert(!BoundaryCondition<Free<PlaneStrain<>>, Spatial<>>);

// What a particle costs: x v m V, the stress that can be there, the law's history, and F or corners where needed.
template <class Shape, class Law, class S = PlaneStrain<>>
constexpr std::size_t bytes = Body<Shape, Law, S>::bytes_per_particle;
static_assert(bytes<Ugimp, Hypoelastic> == (4 + 2 + 4) * 8);
static_assert(bytes<Ugimp, Hypoelastic, PlaneStrain<float>> == (4 + 2 + 4) * 4);
static_assert(bytes<Ugimp, PolynomialEos> == (4 + 2 + 1 + 1) * 8);
static_assert(bytes<Ugimp, JonesWilkinsLee> == (4 + 2 + 1 + 3) * 8);
static_assert(bytes<Ugimp, JonesWilkinsLee, Spatial<>> == (6 + 2 + 1 + 3) * 8);
static_assert(bytes<CpdiQuad, JohnsonHolmquist2> == (4 + 2 + 4 + 2) * 8 + 16 + 16);
static_assert(bytes<CpdiQuad, WithTensileLaw<JohnsonHolmquist2>> == (4 + 2 + 4 + 11) * 8 + 16 + 16);
static_assert(bytes<Cpgimp, Hypoelastic> == (4 + 2 + 4 + 4) * 8);
static_assert(bytes<Linear, NeoHookean, Uniaxial<>> == (2 + 2 + 3 + 1) * 8);
static_assert(bytes<Ugimp, Hypoelastic, Radial<>> == (2 + 2 + 3) * 8);

TEST(Bytes, AreThoseOfTheColumns) {
  Body<CpdiQuad, Hypoelastic> body{"body", {}, {}};
  fill(body, {0, 0}, {1, 1}, .01);
  const std::size_t corners = body.shape.corner.size() * sizeof(CpdiQuad::Point);
  const std::size_t quads = body.shape.quad.size() * sizeof(CpdiQuad::Quad);
  const std::size_t stored = std::size_t(body.column_count) * body.columns().size() * sizeof(double) + corners + quads;
  EXPECT_NEAR(double(stored) / double(body.size()), double(body.bytes_per_particle), 0.5);  // 101^2 corners on 100^2
}

}  // namespace
