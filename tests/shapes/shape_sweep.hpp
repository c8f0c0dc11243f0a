// SPDX-License-Identifier: MIT
#pragma once
#include <gtest/gtest.h>
#include <mpm/mpm.hpp>
#include <algorithm>
#include <map>
#include <random>

// What every shape function must obey, in each space it is for, in double and in float. One line sweeps a shape:
//
//   MPM_SWEEP_SHAPE(MyShape, my::Shape, Gradient::of_weight, mpm::Uniaxial, mpm::PlaneStrain);
namespace mpm::shape_laws {

enum class Gradient {
  of_weight,  ///< grad w is the derivative of w with respect to the particle's position
  of_domain   ///< it is an average over the domain, which differs
};

template <class ShapeT, class SpaceT, Gradient Kind>
struct Swept {
  using Shape = ShapeT;
  using S = SpaceT;
  static constexpr Gradient gradient = Kind;
};

template <class T>
class ShapeSweep : public ::testing::Test {
 public:
  using Shape = typename T::Shape;
  using S = typename T::S;
  using Scalar = typename S::Scalar;
  using BodyType = Body<Shape, Hypoelastic, S>;
  static constexpr int dimension = S::dimension;
  static constexpr Scalar cell = Scalar(0.13);
  static constexpr double epsilon = std::numeric_limits<Scalar>::epsilon();

  std::mt19937_64 engine{20240521};
  const Grid<S> grid{lower(), cell, cells()};

  Scalar number(double low, double high) { return Scalar(std::uniform_real_distribution<>(low, high)(engine)); }

  /// One particle with a random domain, its centre at least `margin` cells from the faces.
  BodyType particle(double margin) {
    BodyType body{"particle", {}, {}};
    Vector<S> x;
    for (int d = 0; d < dimension; ++d) x[d] = grid.origin()[d] + cell * number(margin, grid.cells(d) - margin);
    if constexpr (requires { body.shape.half_size; })
      for (double& l : body.shape.half_size) l = double(cell) * double(number(0.1, 0.5));
    if constexpr (Shape::domain_motion == DomainMotion::corners) {
      for (const auto& [i, j] : {std::pair{-1, -1}, {1, -1}, {1, 1}, {-1, 1}})
        body.shape.corner.push_back({double(x[0]) + double(cell) * (0.4 * i + double(number(-0.2, 0.2))),
                                     double(x[1]) + double(cell) * (0.4 * j + double(number(-0.2, 0.2)))});
      add_quad(body, {0, 1, 2, 3});
    } else {
      body.add(x, 1, Vector<S>::Zero());
    }
    if constexpr (BodyType::stores_F) body.store_F(0, near_identity());
    return body;
  }

  struct Node {
    Vector<S> x;
    double w = 0;
    std::array<double, dimension> gradient{};
  };
  /// The stencil of the one particle, nodes that stand twice added up.
  std::map<int, Node> nodes(const BodyType& body) const {
    std::map<int, Node> found;
    for (const auto& [I, w, gradient] : make_stencil(body, 0, grid)) {
      Node& node = found[I];
      node.x = grid.position(I);
      node.w += double(w);
      for (int d = 0; d < dimension; ++d) node.gradient[d] += double(gradient[d]);
    }
    return found;
  }

  /// How far the sums over the stencil are from what they must be, in units of round-off (gradients times the cell).
  struct Residuals {
    double unity = 0, gradient = 0, position = 0, jacobian = 0, lowest_weight = 1;
  };
  Residuals residuals(const BodyType& body) const {
    Residuals r;
    Eigen::Matrix<double, dimension, dimension> jacobian = -decltype(jacobian)::Identity();
    Eigen::Matrix<double, dimension, 1> gradient = decltype(gradient)::Zero(),
                                        position = -body.position(0).template cast<double>();
    r.unity = -1;
    for (const auto& [I, node] : nodes(body)) {
      r.lowest_weight = std::min(r.lowest_weight, node.w);
      r.unity += node.w;
      for (int i = 0; i < dimension; ++i) {
        gradient[i] += node.gradient[i];
        position[i] += node.w * double(node.x[i]);
        for (int j = 0; j < dimension; ++j) jacobian(i, j) += double(node.x[i]) * node.gradient[j];
      }
    }
    r.unity = std::abs(r.unity) / epsilon;
    r.gradient = gradient.norm() * double(cell) / epsilon;
    r.position = position.norm() / epsilon;
    r.jacobian = jacobian.norm() * double(cell) / epsilon;
    return r;
  }

 private:
  /// Stretched and sheared by up to a third.
  Tensor<Scalar> near_identity() {
    const auto n = [&] { return number(-0.3, 0.3); };
    return Tensor<Scalar>::identity() + Tensor<Scalar>{n(), n(), n(), n(), n(), n(), n(), n(), n()};
  }
  static Vector<S> lower() {
    Vector<S> x;
    for (int d = 0; d < dimension; ++d) x[d] = Scalar(0.7 - 0.5 * d);
    return x;
  }
  static std::array<int, dimension> cells() {
    std::array<int, dimension> n;
    for (int d = 0; d < dimension; ++d) n[d] = 9 - d;
    return n;
  }
};
TYPED_TEST_SUITE_P(ShapeSweep);

TYPED_TEST_P(ShapeSweep, ReproducesLinearFields) {
  for (int trial = 0; trial < 300; ++trial) {
    const auto r = this->residuals(this->particle(2.5));
    ASSERT_GE(r.lowest_weight, -8 * this->epsilon);
    ASSERT_LT(r.unity, 100);
    ASSERT_LT(r.gradient, 1000);
    ASSERT_LT(r.position, 100);
    ASSERT_LT(r.jacobian, 2000);
  }
}

/// The domain of a particle at a face passes it, and is cut off there; a shape without domains has nothing to lose.
TYPED_TEST_P(ShapeSweep, FoldingAtFacesKeepsTheSums) {
  constexpr bool samples_a_point = !requires(typename TestFixture::Shape shape) {
    shape.half_size;
  }
  &&TestFixture::Shape::domain_motion == DomainMotion::rigid;
  int at_face = 0;
  for (int trial = 0; trial < 300; ++trial) {
    const auto body = this->particle(0);
    for (const auto& [I, w, gradient] : make_stencil(body, 0, this->grid)) {
      ASSERT_GE(I, 0);
      ASSERT_LT(std::size_t(I), this->grid.size());
    }
    const auto r = this->residuals(body);
    ASSERT_LT(r.unity, 100);
    ASSERT_LT(r.gradient, 1000);
    if constexpr (samples_a_point) {
      ASSERT_LT(r.position, 100);
      ASSERT_LT(r.jacobian, 2000);
    }
    at_face += (body.position(0) - this->grid.origin()).minCoeff() < this->cell / 2;
  }
  EXPECT_GT(at_face, 5);
}

TYPED_TEST_P(ShapeSweep, GradientIsTheDerivativeOfTheWeight) {
  constexpr int axes = TestFixture::dimension;
  if constexpr (TypeParam::gradient == Gradient::of_weight && sizeof(this->cell) == 8) {
    const double step = 1e-6 * double(this->cell);
    for (int trial = 0; trial < 100; ++trial) {
      auto body = this->particle(2.5);
      const auto here = this->nodes(body);
      for (int d = 0; d < axes; ++d) {
        const double x = body.x(d)[0];
        body.x(d)[0] = x + step;
        auto above = this->nodes(body);
        body.x(d)[0] = x - step;
        auto below = this->nodes(body);
        body.x(d)[0] = x;
        double off = 0;
        for (const auto& [I, node] : here)
          off = std::max(off, std::abs((above[I].w - below[I].w) / (2 * step) - node.gradient[d]));
        EXPECT_LT(off, 1e-4 / double(this->cell));
      }
    }
  }
}

/// The ordering of particles by block relies on the reach.
TYPED_TEST_P(ShapeSweep, NoWeightBeyondTheReach) {
  constexpr int axes = TestFixture::dimension;
  for (int trial = 0; trial < 300; ++trial) {
    const auto body = this->particle(2.5);
    const auto reach = body.shape.reach(body, 0, this->grid);
    double beyond = 0;
    for (const auto& [I, node] : this->nodes(body))
      for (int d = 0; d < axes; ++d)
        if (std::abs(double(node.x[d] - body.x(d)[0])) > double(reach[d]) + double(this->cell))
          beyond += std::abs(node.w);
    EXPECT_LT(beyond, 1e-5);
  }
}

REGISTER_TYPED_TEST_SUITE_P(ShapeSweep, ReproducesLinearFields, FoldingAtFacesKeepsTheSums,
                            GradientIsTheDerivativeOfTheWeight, NoWeightBeyondTheReach);

template <class Shape, Gradient Kind, template <class> class... Spaces>
using AllSpaces = ::testing::Types<Swept<Shape, Spaces<double>, Kind>..., Swept<Shape, Spaces<float>, Kind>...>;

}  // namespace mpm::shape_laws

/// Sweeps one shape: a name for the test, the shape, what its gradient is, and the spaces it is for.
#define MPM_SWEEP_SHAPE(Name, Shape, Kind, ...)                       \
  namespace mpm::shape_laws {                                         \
  using SweptTypes##Name = AllSpaces<Shape, Kind, __VA_ARGS__>;       \
  INSTANTIATE_TYPED_TEST_SUITE_P(Name, ShapeSweep, SweptTypes##Name); \
  }                                                                   \
  static_assert(mpm::ShapeFunction<Shape>)
