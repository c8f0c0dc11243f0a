// SPDX-License-Identifier: MIT
#pragma once
#include <mpm/passes/gather.hpp>
#include <vector>

namespace mpm {

/// The velocity gradient as it is.
struct OwnDilatation {
  template <class L>
  const L& operator()(std::size_t, const L& gradient) const {
    return gradient;
  }
};

/// The velocity gradient with the mean rate of volume, weighted by volume, of the particles in the same cell. A mean is
/// a projection that no volume is lost in, so it stiffens nothing, and Irons' bound holds as it is.
template <class S>
class CellDilatation {
 public:
  using Scalar = typename S::Scalar;

  /// Finds the means of the particles of `chunks` under the nodal velocities; summed in the order of the particles.
  template <class Body, class Nodes>
  void find(const Body& body, const ChunkList& chunks, const Nodes& nodes, const Grid<S>& grid,
            const std::vector<Vector<S>>& velocity) {
    cell_.resize(body.size()), rate_.resize(body.size()), sum_.resize(grid.size()), volume_.resize(grid.size());
    chunks.for_each_entry([&](std::size_t p) {
      int node = 0;
      for (int d = 0; d < S::dimension; ++d)
        node += std::clamp(int(grid.coordinate(body.x(d)[p], d)), 0, grid.cells(d) - 1) * grid.stride(d);
      cell_[p] = node;
      rate_[p] = trace(velocity_gradient<S>(make_stencil(body, p, nodes), velocity, body.x(0)[p]));
    });
    const auto for_each = [&](const auto& f) {
      for (std::size_t k = 0; k < chunks.size(); ++k)
        for (std::size_t p = chunks.first(k); p < chunks.first(k) + std::size_t(chunks.count(k)); ++p)
          f(std::size_t(cell_[p]), p);
    };
    for_each([&](std::size_t c, std::size_t) { sum_[c] = volume_[c] = 0; });
    for_each(
        [&](std::size_t c, std::size_t p) { sum_[c] += body.volume()[p] * rate_[p], volume_[c] += body.volume()[p]; });
  }

  /// L with the mean for its trace, by the same change of each normal component that the space strains.
  Tensor<Scalar> operator()(std::size_t p, Tensor<Scalar> L) const {
    constexpr int normals = S::hoop ? 3 : S::dimension;
    const auto c = std::size_t(cell_[p]);
    const Scalar change = (sum_[c] / volume_[c] - rate_[p]) / normals;
    L.xx += change;
    if constexpr (S::dimension > 1) L.yy += change;
    if constexpr (S::dimension > 2 || S::hoop) L.zz += change;
    return L;
  }

 private:
  std::vector<int> cell_;             ///< of every particle
  std::vector<Scalar> rate_;          ///< of every particle's volume, 1/s
  std::vector<Scalar> sum_, volume_;  ///< of every cell
};

}  // namespace mpm
