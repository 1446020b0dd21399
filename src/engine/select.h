// SPDX-License-Identifier: MIT
#pragma once
#include <string>

#include "engine/engine.h"
#include "engine/plan.h"

namespace freshet {

/// The backend, and the instruction set of the cpu backend: "" for the best that the machine has.
struct BackendChoice {
  BackendName backend = BackendName::cpu;
  std::string isa;
};

/// Makes the engine of a plan. It is the only function that knows all backends and instruction
/// sets. Throws Error (kind scene) for an instruction set or a solver that is not available.
std::unique_ptr<Engine> make_engine(const EnginePlan& plan, const BackendChoice& choice);

/// Whether this build has a solver on a backend in 2D or 3D: some builds exclude some.
bool has_solver(SolverName name, BackendName backend = BackendName::cpu, int dimension = 2);

/// The name of the instruction set that `isa` selects; the best one if empty. Throws Error (kind
/// scene) if it is not available.
std::string instruction_set(const std::string& isa);
/// The number of threads that `threads` selects; 0: as many as the machine has. Throws Error (kind
/// scene) if it is above thread_limit().
int thread_count(int threads);
/// With `threads` = 0: at most one for every 2048 particles.
int thread_count(int threads, double particles);
/// Four times as many as the machine has, and 64 at least.
int thread_limit();

}  // namespace freshet
