// SPDX-License-Identifier: MIT
// Compiled once for every instruction set.
#include "backend/cpu/cpu_backend.h"
#include "sim/engines/all.h"

namespace freshet {
inline namespace FRESHET_ISA {

std::unique_ptr<Engine> make_cpu_engine_2d(const EngineInput& input) {
  return make_engine_on<2>(CpuBackend<2>(input.threads), input);
}

}  // namespace FRESHET_ISA
}  // namespace freshet
