// SPDX-License-Identifier: MIT
#include "backend/cpu/cpu_backend.h"
#include "sim/engine_of.h"
#include "sim/engines/cpu.h"
#include "sim/parameters.h"
#include "solvers/mueller2003.h"

namespace freshet {

std::unique_ptr<Engine> FRESHET_CPU_ENGINE(mueller2003_2d)(const Scene& scene,
                                                           const Derived& derived,
                                                           const Sample& sample, int threads) {
  using Backend = CpuBackend<2>;
  using Solver = Mueller2003<2, Backend>;
  return std::make_unique<EngineOf<2, Solver, Backend>>(
      Backend(threads), Solver{mueller2003_parameters<2>(scene, derived)}, sample);
}

}  // namespace freshet
