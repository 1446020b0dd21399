// SPDX-License-Identifier: MIT
/// Divergence-free SPH for incompressible and viscous fluids: solvers/dfsph.h.
#include "methods/solver_methods.h"

namespace freshet {

SolverMethod dfsph_method() {
  SolverMethod m = incompressible_method();
  m.solves = {"divergence", "density"};
  m.keys.insert(m.keys.end(), {"solver.warm_start", "solver.divergence_tolerance",
                               "solver.density_correction", "solver.iteration"});
  m.density_tolerance = 1e-4;
  m.correction = DensityCorrection::gradual;
  m.solver = SolverName::dfsph;
  m.name = "dfsph";
  m.paper = "Bender and Koschier 2017";
  return m;
}

}  // namespace freshet
