// SPDX-License-Identifier: MIT
#include "backend/reference/reference_backend.h"
#include "sim/engines/all.h"

namespace freshet {
inline namespace FRESHET_ISA {

std::unique_ptr<Engine> make_reference_engine_3d(const EngineInput& input) {
  const auto& solver = input.scene.solver;
  return make_engine_on<3>(ReferenceBackend<3>(solver.search, solver.neighbor_order), input);
}

}  // namespace FRESHET_ISA
}  // namespace freshet
