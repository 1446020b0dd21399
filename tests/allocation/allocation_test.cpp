// SPDX-License-Identifier: MIT
// A warm step allocates no memory. The tests replace malloc to count its calls, so they are a
// program of their own.
#include <gtest/gtest.h>

#include <atomic>
#include <cstdlib>

#include "sim/small_scenes.h"

namespace {
std::atomic<long> calls{0};
}
extern "C" {
void* __libc_malloc(std::size_t);
void* __libc_calloc(std::size_t, std::size_t);
void* __libc_realloc(void*, std::size_t);
void* __libc_memalign(std::size_t, std::size_t);

void* malloc(std::size_t n) {
  ++calls;
  return __libc_malloc(n);
}
void* calloc(std::size_t n, std::size_t size) {
  ++calls;
  return __libc_calloc(n, size);
}
void* realloc(void* p, std::size_t n) {
  ++calls;
  return __libc_realloc(p, n);
}
void* aligned_alloc(std::size_t alignment, std::size_t n) {
  ++calls;
  return __libc_memalign(alignment, n);
}
}

namespace freshet::test {
namespace {

/// Calls in 20 steps, after 60 steps to warm up.
long allocations(const std::string& text, int threads) {
  Simulation sim = simulation_of(text, "cpu", {threads, ""});
  for (int k = 0; k < 60; ++k) sim.step();
  const long before = calls;
  for (int k = 0; k < 20; ++k) sim.step();
  return calls - before;
}

std::string tank(const std::string& solver, const std::string& walls, const std::string& time) {
  return "[domain]\nmax = [1.0, 1.0]\n" + walls +
         "[particles]\nspacing = 0.05\n[fluid]\nmin = [0, 0]\nmax = [1.0, 0.5]\n[solver]\n" +
         solver + "sound_speed = 30.0\n[time]\nend = 1.0\n" + time;
}

TEST(Allocation, CallsAreCounted) {
  const long before = calls;
  const Simulation sim = simulation_of(tank("name = \"wcsph\"\n", "", "step = 0.0005\n"));
  EXPECT_GT(calls - before, 100);
}

TEST(Allocation, WarmStepDoesNotAllocate) {
  for (const int threads : {1, 2}) {
    EXPECT_EQ(0, allocations(tank("name = \"wcsph\"\n", "", "step = 0.0005\n"), threads));
    EXPECT_EQ(0, allocations(tank("name = \"delta_sph\"\ndensity_diffusion = \"antuono2010\"\n",
                                  "[walls]\nmethod = \"adami2012\"\n",
                                  "step = \"adaptive\"\nstep_max = 0.01\n"),
                             threads));
    EXPECT_EQ(0, allocations(tank("name = \"delta_sph\"\n", "[walls]\nmethod = \"ghost\"\n",
                                  "step = 0.0005\n"),
                             threads));
    EXPECT_EQ(0, allocations(tank("name = \"wcsph\"\n", "periodic = \"x\"\n", "step = 0.0005\n"),
                             threads));
  }
}

// The inlet has stopped, no particle reaches the outlet, and a counter counts.
TEST(Allocation, WarmStepWithIdleFlowsDoesNotAllocate) {
  const std::string flows =
      "[inlet]\ncenter = [0.5, 0.8]\ndirection = [0, -1]\nwidth = 0.1\nspeed = 5\nstop = 0.01\n"
      "[outlet]\nmin = [2, 2]\nmax = [3, 3]\n[counter]\ncenter = [0.5, 0]\ndirection = [1, 0]\n";
  EXPECT_EQ(0, allocations(tank("name = \"wcsph\"\n", flows, "step = 0.0005\n"), 2));
}

}  // namespace
}  // namespace freshet::test
