// SPDX-License-Identifier: MIT
#pragma once
#include <type_traits>

#include "engine/engine_of.h"

namespace freshet {
inline namespace FRESHET_ISA {

// Each is defined in a separate file, which is made from instantiate/engine.cpp.in.
template <int D> std::unique_ptr<Engine> make_cpu_engine(const EnginePlan& plan);
template <int D> std::unique_ptr<Engine> make_reference_engine(const EnginePlan& plan);

template <class B> B make_backend(const EnginePlan& p) {
  if constexpr (std::is_constructible_v<B, int>) return B(p.threads);
  else return B(p.search, p.neighbor_order);
}

/// Makes an engine; null if the build lacks the plan's solver. FRESHET_SOLVERS calls
/// FRESHET_SOLVER(name) for each solver that src/CMakeLists.txt compiles.
template <int D, class B> std::unique_ptr<Engine> make_engine_on(const EnginePlan& p) {
  std::unique_ptr<Stepper<D, B>> stepper;
#define FRESHET_SOLVER(name) \
  if (p.solver == SolverName::name) stepper = make_stepper<SolverName::name, D, B>(p);
  FRESHET_SOLVERS
#undef FRESHET_SOLVER
  if (!stepper) return nullptr;
  return std::make_unique<EngineOf<D, B>>(make_backend<B>(p), std::move(stepper), p);
}

}  // namespace FRESHET_ISA
}  // namespace freshet
