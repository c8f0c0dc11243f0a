// SPDX-License-Identifier: MIT
#pragma once
#include <mpm/body.hpp>
#include <tuple>

namespace mpm {

/// A column of policies, one a body: `PerBody<CpdiQuad, Ugimp>` is a Shape, `PerBody<JohnsonHolmquist2, PolynomialEos>`
/// a Material. A single policy beside a column serves every body.
template <class... Policies>
struct PerBody {};

namespace detail {

template <class T>
struct Column {
  static constexpr int size = 1;
  template <int>
  using At = T;
};
template <class... T>
struct Column<PerBody<T...>> {
  static constexpr int size = sizeof...(T);
  template <int I>
  using At = std::tuple_element_t<I, std::tuple<T...>>;
};

template <class Shape, class Material, class Space>
struct BodiesOf {
  static constexpr int shapes = Column<Shape>::size, laws = Column<Material>::size;
  static_assert(shapes == laws || shapes == 1 || laws == 1,
                "mpm::PerBody: the columns of Shape and Material differ in length; give one entry a body in each, or "
                "one policy for all");
  static constexpr int count = shapes > laws ? shapes : laws;

  template <int I>
  using At = Body<typename Column<Shape>::template At<I>, typename Column<Material>::template At<I>, Space>;
  template <class Indices>
  struct List;
  template <int... I>
  struct List<std::integer_sequence<int, I...>> {
    using Type = std::tuple<At<I>...>;
  };
  using Type = typename List<std::make_integer_sequence<int, count>>::Type;
};

}  // namespace detail

/// std::tuple of the bodies that a Shape and a Material column make.
template <class Shape, class Material, class Space>
using Bodies = typename detail::BodiesOf<Shape, Material, Space>::Type;

}  // namespace mpm
