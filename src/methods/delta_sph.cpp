// SPDX-License-Identifier: MIT
/// delta-SPH: weakly compressible SPH with diffusion of the density: solvers/delta_sph.h.
#include "methods/solver_methods.h"

namespace freshet {

SolverMethod delta_sph_method() {
  SolverMethod m = weakly_compressible_method();
  m.keys.insert(m.keys.end(),
                {"solver.density_diffusion", "solver.delta", "solver.acoustic_damping"});
  m.solver = SolverName::delta_sph;
  m.name = "delta_sph";
  m.paper = "Antuono et al. 2010";
  return m;
}

}  // namespace freshet
