// SPDX-License-Identifier: MIT
#include "backend/reference/reference_backend.h"
#include "sim/engine_of.h"
#include "sim/parameters.h"
#include "solvers/mueller2003.h"

namespace freshet {

std::unique_ptr<Engine> make_reference_mueller2003_2d(const Scene& scene, const Derived& derived,
                                                      const Sample& sample) {
  using Backend = ReferenceBackend<2>;
  using Solver = Mueller2003<2, Backend>;
  return std::make_unique<EngineOf<2, Solver, Backend>>(
      Backend(scene.solver.search, scene.solver.neighbor_order),
      Solver{mueller2003_parameters<2>(scene, derived)}, sample);
}

}  // namespace freshet
