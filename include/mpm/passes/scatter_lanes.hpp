// SPDX-License-Identifier: MIT
#pragma once
#include <mpm/body_force.hpp>
#include <mpm/passes/domain_weights.hpp>
#include <mpm/passes/scatter.hpp>
#include <mpm/passes/stable_step_lanes.hpp>

// The passes of scatter.hpp for shape functions in modes.
namespace mpm::lanes {

namespace detail {
using namespace mpm::detail;

/// Where a node's sums stand in its words: momentum, mass and force. In the plane the mass needs a word of its own.
template <class S>
struct ScatterRecord {
  static constexpr int D = S::dimension;
  static constexpr bool own_mass = D == 2;
  static constexpr int words = D == 3 ? 2 : 1;
  static constexpr int mass = D == 1 ? 2 : 3;  ///< slot in the first word
  static constexpr int force_word = D == 3, force = D == 3 ? 0 : D;
};

/// m b of a register of particles, of which `valid` are meant.
template <class Body, class V, class Force>
[[gnu::always_inline]] inline void weight_of(const Body& body, std::size_t p, int valid, const V& m,
                                             const Force& body_force, double time, V* b) {
  constexpr int D = Body::dimension;
  if constexpr (std::is_same_v<Force, UniformBodyForce<typename Body::SpaceType>>) {
    for (int d = 0; d < D; ++d) b[d] = m * V(body_force(body, p, time)[d]);
  } else {
    for (int k = 0; k < std::min(valid, V::size); ++k) {
      const auto at = body_force(body, p + std::size_t(k), time);
      for (int d = 0; d < D; ++d) b[d].v[k] = m[k] * at[d];
    }
  }
}
/// Adds two neighbouring slots of a word to two numbers in memory.
template <int Slot, class T>
[[gnu::always_inline]] inline void add_pair(const Word<T>& word, T* to) {
  Native<T, 2> sum;
  std::memcpy(&sum, to, sizeof(sum));
  sum += __builtin_shufflevector(word, word, Slot, Slot + 1);
  std::memcpy(to, &sum, sizeof(sum));
}

template <int Slot, class T, int D>
[[gnu::always_inline]] inline void add(const Word<T>& word, Eigen::Matrix<T, D, 1>& to) {
  if constexpr (D == 2) {
    add_pair<Slot>(word, to.data());
  } else {
    for (int d = 0; d < D; ++d) to[d] += word[Slot + d];
  }
}

/// What a chunk of particles gives to its nodes: a word as a value (momentum, mass, weight) and one an axis as slopes
/// (the flux of force).
template <class S, class Weights>
struct Given {
  using Record = ScatterRecord<S>;
  using W = Word<typename S::Scalar>;
  W value[Record::words][chunk_size];
  W slope[S::dimension][chunk_size];
  W mass[Record::own_mass ? Weights::mass_words : 1][chunk_size];  ///< by mode, where it has no place in the words

  template <What what, class Body, class Force>
  [[gnu::always_inline]] void compute(const Body& body, std::size_t first, int size, const Grid<S>& grid,
                                      const Weights& w, const Force& body_force, double time) {
    using V = typename Body::Lane;
    constexpr int D = S::dimension;
    for (int l = 0; l < chunk_size; l += V::size) {
      const std::size_t p = first + std::size_t(l);
      const V m = V::load(body.mass() + p);
      V v[3]{}, b[3]{}, s[3][3]{};
      if constexpr (gives_mass<what> && Record::own_mass) w.weigh(l, m, mass);
      if constexpr (gives_momentum<what>)
        for (int d = 0; d < D; ++d) v[d] = m * V::load(body.v(d) + p);
      if constexpr (gives_forces<what>) {
        const auto stress = body.template stress<V>(p);
        const V volume = V::load(body.volume() + p), scale = -volume * V(grid.inverse_cell());
        weight_of(body, p, size - l, m, body_force, time, b);
        if constexpr (S::hoop) b[0] -= volume * stress.zz / V::load(body.x(0) + p);
        s[0][0] = scale * stress.xx;
        if constexpr (D > 1) s[0][1] = s[1][0] = scale * stress.xy, s[1][1] = scale * stress.yy;
        if constexpr (D > 2)
          s[0][2] = s[2][0] = scale * stress.zx, s[1][2] = s[2][1] = scale * stress.yz, s[2][2] = scale * stress.zz;
      }
      const V zero(0);
      if constexpr (D == 1) {
        to_words(v[0], b[0], m, zero, &value[0][l]);
        to_words(zero, s[0][0], zero, zero, &slope[0][l]);
      } else if constexpr (D == 2) {
        to_words(v[0], v[1], b[0], b[1], &value[0][l]);
        for (int d = 0; d < D; ++d) to_words(zero, zero, s[d][0], s[d][1], &slope[d][l]);
      } else {
        to_words(v[0], v[1], v[2], m, &value[0][l]);
        to_words(b[0], b[1], b[2], zero, &value[1][l]);
        for (int d = 0; d < D; ++d) to_words(s[d][0], s[d][1], s[d][2], zero, &slope[d][l]);
      }
    }
  }
};

}  // namespace detail

/// m_I += w m and (m v)_I += w m v, f_I += -V sigma grad w + w m b, or both at once. Returns the first particle whose
/// forces come from a stress that is no finite number, or body.size() or more. Where it `measures`, `inverse_square`
/// becomes 1/dt^2 of the largest stable step of the chunks that looks_at(chunk), by `limits`; infinity if these are not
/// known.
template <What what, bool measures, class Body, class Force, class F, class S = typename Body::SpaceType>
std::size_t scatter(const Body& body, const ParticleOrder& order, Grid<S>& grid, std::vector<Vector<S>>& momentum,
                    const Force& body_force, double time, const std::vector<StepLimits<typename S::Scalar>>& limits,
                    const F& looks_at, typename S::Scalar& inverse_square) {
  using Scalar = typename S::Scalar;
  using V = typename Body::Lane;
  using Record = detail::ScatterRecord<S>;
  using Weights = typename detail::WeightsOf<Body>::Type;
  using Word = detail::Word<Scalar>;
  constexpr int D = S::dimension, K = Body::Shape::axis_nodes, count = shapes::power(K, D);
  constexpr bool force = gives_forces<what>, mass = gives_mass<what>, velocity = gives_momentum<what>;
  constexpr bool continued = detail::continues_linearly<typename Body::Shape>;

  const auto give_chunk = [&](std::size_t first, int size, const Weights& w, detail::Given<S, Weights>& given)
      __attribute__((always_inline)) {
    std::size_t bad = std::numeric_limits<std::size_t>::max();
    if constexpr (force)
      for (int l = 0; l < size; l += V::size)
        bad = std::min(bad, first_unsound<V>(body, first + std::size_t(l), std::min(size - l, V::size)));
    given.template compute<what>(body, first, size, grid, w, body_force, time);
    for (int p = 0, next; p < size; p = next) {
      next = w.run_end(p, size);
      const detail::StencilNodes<S, K> nodes(grid, w.anchor, p);
      shapes::unrolled<Record::words>([&](auto word) __attribute__((always_inline)) {
        constexpr bool slopes = force && word == Record::force_word;
        Word sum[count]{};
        for (int q = p; q < next; ++q) {
          Word mode[count];
          if constexpr (slopes) {
            Word slope[D];
            for (int d = 0; d < D; ++d) slope[d] = given.slope[d][q];
            detail::modes_of<D, K>(given.value[word][q], slope, w, q, mode);
          } else {
            detail::modes_of<D, K>(given.value[word][q], w, q, mode);
          }
          shapes::unrolled<count>([&](auto I) __attribute__((always_inline)) { sum[I] += mode[I]; });
        }
        shapes::all_to_nodes<D, K>(sum);
        if constexpr (continued) nodes.fold_sums(sum);
        nodes.for_each([&](auto I, std::size_t n) __attribute__((always_inline)) {
          if constexpr (velocity && word == 0) detail::add<0>(sum[I], momentum[n]);
          if constexpr (slopes) detail::add<Record::force>(sum[I], grid.increment[n]);
          if constexpr (mass && word == 0 && !Record::own_mass) grid.mass[n] += sum[I][Record::mass];
        });
      });
      if constexpr (mass && Record::own_mass) {
        Word sum[K]{};  // a word a row
        for (int q = p; q < next; ++q) w.add_mass(given.mass, q, sum);
        Scalar at[count];
        for (int j = 0; j < K; ++j)
          for (int i = 0; i < K; ++i) at[j * K + i] = sum[j][i];
        shapes::all_to_nodes<D, K>(at);
        if constexpr (continued) nodes.fold_sums(at);
        nodes.for_each([&](auto I, std::size_t n) __attribute__((always_inline)) { grid.mass[n] += at[I]; });
      }
    }
    return bad;
  };
  const auto give = [&](std::size_t begin, std::size_t end, V& needed) {
    Weights w;
    detail::Given<S, Weights> given;
    std::size_t bad = std::numeric_limits<std::size_t>::max();
    for (std::size_t first = begin, next_chunk; first < end; first = next_chunk) {
      next_chunk = std::min(end, first / chunk_size * chunk_size + chunk_size);
      const int size = int(next_chunk - first);
      const bool fit = w.compute(body, first, size, grid);
      if (fit) {
        bad = std::min(bad, give_chunk(first, size, w, given));
      } else {
        for (std::size_t p = first; p < next_chunk; ++p)
          bad = std::min(bad, scatter_plainly<what>(body, p, grid, momentum, body_force, time));
      }
      if constexpr (measures) {  // last: the next chunk's weights are found while this waits for its division
        const std::size_t c = first / chunk_size;
        if (looks_at(c))
          needed = larger_or_nan(needed, detail::inverse_square_step(limits[c], body, first, size, grid, w, fit));
      }
    }
    return bad;
  };
  V needed(0);
  const std::size_t bad = for_each_strip(order, give, needed);
  if constexpr (measures) inverse_square = detail::largest_or_infinite(needed);
  return bad;
}

/// The twin of mpm::scatter_interpolated: out_I += sum_p w_Ip m_p sum_J w_Jp in_J.
template <class Body, class S = typename Body::SpaceType>
void scatter_interpolated(const Body& body, const ParticleOrder& order, const Grid<S>& grid,
                          const std::vector<Vector<S>>& in, std::vector<Vector<S>>& out) {
  using Word = detail::Word<typename S::Scalar>;
  constexpr int D = S::dimension, K = Body::Shape::axis_nodes, count = shapes::power(K, D);
  constexpr bool continued = detail::continues_linearly<typename Body::Shape>;
  const auto plainly = [&](std::size_t p) { mpm::scatter_interpolated(body, p, grid, in, out); };
  for_each_strip(order, [&](std::size_t begin, std::size_t end) {
    typename detail::WeightsOf<Body>::Type w;
    for (std::size_t first = begin; first < end; first += chunk_size) {
      const int size = int(std::min<std::size_t>(chunk_size, end - first));
      if (!w.compute(body, first, size, grid)) {
        for (std::size_t p = first; p < first + std::size_t(size); ++p) plainly(p);
        continue;
      }
      for (int p = 0, next; p < size; p = next) {
        next = w.run_end(p, size);
        const detail::StencilNodes<S, K> nodes(grid, w.anchor, p);
        Word mode[count], sum[count]{};
        nodes.for_each([&](auto I, std::size_t n) __attribute__((always_inline)) {
          mode[I] = Word{};
          for (int d = 0; d < D; ++d) mode[I][d] = in[n][d];
        });
        if constexpr (continued) nodes.continue_field(mode);
        shapes::all_to_modes<D, K>(mode);
        for (int q = p; q < next; ++q) {
          Word seen, part[count];
          detail::value_of<D, K>(mode, w, q, seen);
          detail::modes_of<D, K>(Word(seen * body.mass()[first + std::size_t(q)]), w, q, part);
          shapes::unrolled<count>([&](auto I) __attribute__((always_inline)) { sum[I] += part[I]; });
        }
        shapes::all_to_nodes<D, K>(sum);
        if constexpr (continued) nodes.fold_sums(sum);
        nodes.for_each([&](auto I, std::size_t n) __attribute__((always_inline)) { detail::add<0>(sum[I], out[n]); });
      }
    }
    return end;
  });
  for (std::size_t p = order.tail_begin(); p < body.size(); ++p) plainly(p);
}

}  // namespace mpm::lanes
