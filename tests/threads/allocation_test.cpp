// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>
#include <mpm/mpm.hpp>
#include <atomic>
#include <cstdlib>
#include <new>

// A step allocates nothing once its arrays have their sizes, not even when particles change cells and are sorted anew.

namespace {
std::atomic<long> allocations{0};
void* counted(std::size_t size, std::size_t alignment) {
  ++allocations;
  void* memory = std::aligned_alloc(alignment, (size + alignment - 1) / alignment * alignment);
  if (memory == nullptr) throw std::bad_alloc();
  return memory;
}
}  // namespace

// Not inlined: g++ would take one end of a pair for malloc and not the other.
[[gnu::noinline]] void* operator new(std::size_t size) {
  return counted(size, alignof(std::max_align_t));
}
[[gnu::noinline]] void* operator new(std::size_t size, std::align_val_t alignment) {
  return counted(size, std::size_t(alignment));
}
[[gnu::noinline]] void operator delete(void* memory) noexcept {
  std::free(memory);
}
[[gnu::noinline]] void operator delete(void* memory, std::size_t) noexcept {
  std::free(memory);
}
[[gnu::noinline]] void operator delete(void* memory, std::align_val_t) noexcept {
  std::free(memory);
}
[[gnu::noinline]] void operator delete(void* memory, std::size_t, std::align_val_t) noexcept {
  std::free(memory);
}

namespace mpm {
namespace {

template <class SolverT>
struct Allocation : ::testing::Test {};
using Solvers = ::testing::Types<  //
    Solver<Ugimp, Hypoelastic, Usl>, Solver<Ugimp, Hypoelastic, Usf>, Solver<CpdiQuad, Hypoelastic, Musl>,
    Solver<Cpdi, NeoHookean, Usf>, Solver<CubicBspline, Hypoelastic, Fmpm>, Solver<QuadraticBspline, Hypoelastic, Apic>,
    Solver<CpdiQuad, Hypoelastic, DynamicRelaxation<>>>;
TYPED_TEST_SUITE(Allocation, Solvers);

TYPED_TEST(Allocation, StepsTakeNoMemory) {
  typename TypeParam::template BodyAt<0> block{"block", {}, {.density = 1000, .young = 1e6, .poisson = .3}};
  // Fast enough to cross several cells, and strips, in the steps counted.
  fill(block, {3.05, 3.05}, {8.05, 8.05}, .5, [](const auto&) { return true; }, {10, 10});
  TypeParam solver{Grid<PlaneStrain<>>{{0, 0}, 1, {30, 30}}, std::move(block)};
  for (int k = 0; k < 20; ++k) solver.step();
  const auto where = solver.body().position(0);
  const long before = allocations;
  for (int k = 0; k < 60; ++k) solver.step();
  EXPECT_EQ(allocations - before, 0);
  if constexpr (!requires { solver.integrator.damping; }) {
    EXPECT_GT((solver.body().position(0) - where).norm(), 2);
  }
}

}  // namespace
}  // namespace mpm
