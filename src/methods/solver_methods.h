// SPDX-License-Identifier: MIT
/// The descriptors of the solvers, one file each. A new solver has a line here and in the list of
/// solver_methods.cpp.
#pragma once
#include "freshet/solver_method.h"

namespace freshet {

SolverMethod mueller2003_method();
SolverMethod wcsph_method();
SolverMethod delta_sph_method();
SolverMethod pcisph_method();
SolverMethod iisph_method();
SolverMethod dfsph_method();
SolverMethod pbf_method();

/// What the solvers with Tait's equation of state share.
SolverMethod weakly_compressible_method();
/// What the solvers for the pressure share.
SolverMethod incompressible_method();

}  // namespace freshet
