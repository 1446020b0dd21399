// SPDX-License-Identifier: MIT
#pragma once
#include "engine/wall_forces.h"
#include "solvers/forces.h"

namespace freshet {
inline namespace FRESHET_ISA {

/// Adds the reactions of the walls' viscosity and adhesion terms to the forces on walls.
template <int D, class B, template <int> class Kernel>
void Forces<D, B, Kernel>::add_wall_forces(B& backend, const Fluid& f, const Walls<D>& w,
                                           WallForces<D, B>& forces) const {
  backend.share("wall forces", f, f.v);
  if (c.viscosity == ViscosityMethod::morris1997) {
    forces.add(w.akinci2012, f, morris1997_akinci(f, w));
    forces.add(w.adami2012, f, morris1997_adami(f, w));
    forces.add_ghosts(f, morris1997(f));
  } else if (c.viscosity != ViscosityMethod::artificial) {
    forces.add(w.akinci2012, f, monaghan2005_akinci(f, w));
    forces.add(w.adami2012, f,
               monaghan2005_adami(f, w, c.viscosity == ViscosityMethod::weiler2018));
    forces.add_ghosts(f, monaghan2005(f));
  }
  if (c.tension == SurfaceTensionMethod::akinci2013)
    forces.add(w.akinci2012, f, akinci2013_adhesion(f, w));
}

}  // namespace FRESHET_ISA
}  // namespace freshet
