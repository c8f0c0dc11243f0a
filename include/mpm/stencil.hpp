// SPDX-License-Identifier: MIT
#pragma once
#include <array>

namespace mpm {

/// The nodes one particle talks to: `for (const auto& [I, w, grad] : stencil)` gives node I, w_Ip and grad w_Ip. A node
/// may stand twice (GIMP folded at a face, corners of a CPDI domain wider than three cells, the two ends of a segment);
/// sums over the stencil are what counts.
template <class Scalar, int Dimension, int MaxNodes>
class Stencil {
 public:
  struct Entry {
    int node;
    Scalar weight;
    std::array<Scalar, Dimension> gradient;
  };

  void add(int node, Scalar weight, const std::array<Scalar, Dimension>& gradient) {
    entries_[size_++] = {node, weight, gradient};
  }
  int size() const { return size_; }
  const Entry* begin() const { return entries_.data(); }
  const Entry* end() const { return entries_.data() + size_; }
  Entry* begin() { return entries_.data(); }
  Entry* end() { return entries_.data() + size_; }

 private:
  int size_ = 0;
  std::array<Entry, MaxNodes> entries_;
};

/// One axis of a tensor-product stencil: `size` consecutive nodes from `first`, values and derivatives.
template <class Scalar, int Size>
struct AxisStencil {
  int first = 0;
  std::array<Scalar, Size> w;
  std::array<Scalar, Size> dw;
  static constexpr int size = Size;
};

/// The same where the number of nodes depends on the particle.
template <class Scalar, int MaxNodes>
struct WideAxisStencil {
  int first = 0;
  int size = 0;
  std::array<Scalar, MaxNodes> w;
  std::array<Scalar, MaxNodes> dw;
};

}  // namespace mpm
