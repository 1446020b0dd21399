// SPDX-License-Identifier: MIT
/// Implicit incompressible SPH: solvers/iisph.h.
#include "methods/solver_methods.h"

namespace freshet {

SolverMethod iisph_method() {
  SolverMethod m = incompressible_method();
  m.keys.insert(m.keys.end(), {"solver.warm_start", "solver.density_correction"});
  m.solver = SolverName::iisph;
  m.name = "iisph";
  m.paper = "Ihmsen et al. 2014";
  return m;
}

}  // namespace freshet
