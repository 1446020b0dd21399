// SPDX-License-Identifier: MIT
#pragma once
#include "sim/engine.h"

namespace freshet {

/// The engine that a scene asks for: the one place that knows all solvers and all backends.
/// Throws Error (kind scene) for an instruction set that this machine lacks.
std::unique_ptr<Engine> make_engine(const Scene& scene, const Derived& derived,
                                    const Execution& execution);

/// Whether this build has a solver: the sanitizers' builds leave some out.
bool has_solver(SolverName name);

}  // namespace freshet
