// SPDX-License-Identifier: MIT
/// Particle-based fluid simulation for interactive applications: solvers/mueller2003.h.
#include "methods/solver_methods.h"

namespace freshet {

SolverMethod mueller2003_method() {
  SolverMethod m{};
  m.pressure = PressureFamily::linear;
  m.keys = {"solver.scheme", "solver.stiffness", "solver.speed_limit", "time.integrator"};
  m.instead = {{"solver.kernel", "has the kernels of its paper"}};
  m.walls = WallMethod::reflection;
  m.solver = SolverName::mueller2003;
  m.name = "mueller2003";
  m.paper = "Müller, Charypar and Gross 2003";
  return m;
}

}  // namespace freshet
