// SPDX-License-Identifier: MIT
/// Predictive-corrective incompressible SPH: solvers/pcisph.h.
#include "methods/solver_methods.h"

namespace freshet {

SolverMethod pcisph_method() {
  SolverMethod m = incompressible_method();
  m.keys.push_back("solver.density_correction");
  m.solver = SolverName::pcisph;
  m.name = "pcisph";
  m.paper = "Solenthaler and Pajarola 2009";
  return m;
}

}  // namespace freshet
