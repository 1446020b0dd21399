// SPDX-License-Identifier: MIT
/// The forces on walls by the pair terms of each solver. All use SceneKernel.
#pragma once
#include "engine/wall_forces.h"
#include "kernels/scene_kernel.h"
#include "solvers/incompressible.h"

namespace freshet {
inline namespace FRESHET_ISA {

/// The terms of mueller2003, whose walls act on the fluid as mirror images only.
template <class Terms> struct MirrorTerms {
  Terms terms;
  template <class B, class Fluid, class Walls, class Forces>
  void operator()(B&, const Fluid& f, const Walls&, Forces& forces) const {
    forces.add_ghosts(f, terms.fluid_forces(f));
  }
};

/// The terms of wcsph and delta_sph.
template <class Terms> struct WeaklyCompressibleTerms {
  Terms terms;
  template <class B, class Fluid, class Walls, class Forces>
  void operator()(B&, const Fluid& f, const Walls& w, Forces& forces) const {
    forces.add(w.akinci2012, f, terms.akinci2012_forces(f, w.akinci2012));
    forces.add(w.adami2012, f, terms.adami2012_forces(f, w.adami2012));
    forces.add(w.monaghan2009, f, terms.monaghan2009_forces(f, w));
    forces.add_ghosts(f, terms.fluid_forces(f));
  }
};

/// The terms of the pressure solvers, compiled once for all of them.
template <int D, class B> struct IncompressibleTerms {
  IncompressibleParameters<D> c;
  SceneKernel<D> W;
  void operator()(B& backend, const IncompressibleFluid<D>& f, const Walls<D>& w,
                  WallForces<D, B>& forces) const;
};

}  // namespace FRESHET_ISA
}  // namespace freshet
