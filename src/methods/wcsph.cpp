// SPDX-License-Identifier: MIT
/// Weakly compressible SPH for free surface flows: solvers/wcsph.h.
#include "methods/solver_methods.h"

namespace freshet {

SolverMethod wcsph_method() {
  SolverMethod m = weakly_compressible_method();
  m.integrator = Integrator::symplectic_euler;
  m.solver = SolverName::wcsph;
  m.name = "wcsph";
  m.paper = "Becker and Teschner 2007";
  return m;
}

}  // namespace freshet
