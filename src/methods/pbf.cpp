// SPDX-License-Identifier: MIT
/// Position based fluids: solvers/pbf.h.
#include "methods/solver_methods.h"

namespace freshet {

SolverMethod pbf_method() {
  SolverMethod m = incompressible_method();
  m.predicts_places = true;
  m.solver = SolverName::pbf;
  m.name = "pbf";
  m.paper = "Macklin and Müller 2013";
  return m;
}

}  // namespace freshet
