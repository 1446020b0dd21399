// SPDX-License-Identifier: MIT
/// The forces beside pressure on a backend. Included by the instantiation files only.
#pragma once
#include "sim/engines/make_forces.h"
#include "sim/force_parameters.h"
#include "sim/wall_forces.h"
#include "solvers/forces.h"

namespace freshet {
inline namespace FRESHET_ISA {

/// By the terms that act on the fluid, turned round.
template <int D, class B, template <int> class Kernel>
void Forces<D, B, Kernel>::add_wall_forces(B& backend, const Fluid& f, const Walls<D>& w,
                                           const std::vector<int>& copy_walls,
                                           Field<Vec<D>> on_copy, WallForces<D>& forces) const {
  using Viscosity = typename P::Viscosity;
  const auto on_samples = [&](const auto& wall, const auto& term) {
    forces.add(backend, c.support, wall, f, term);
  };
  const auto on_ghosts = [&](const auto& term) {
    forces.add_ghosts(backend, f, term, copy_walls, on_copy);
  };
  backend.share("wall forces", f, f.v);
  if (c.viscosity == Viscosity::morris1997) {
    on_samples(w.akinci2012, morris1997_akinci(f, w));
    on_samples(w.adami2012, morris1997_adami(f, w));
    on_ghosts(morris1997(f));
  } else if (c.viscosity != Viscosity::solvers_own) {
    on_samples(w.akinci2012, monaghan2005_akinci(f, w));
    on_samples(w.adami2012, monaghan2005_adami(f, w, c.viscosity == Viscosity::weiler2018));
    on_ghosts(monaghan2005(f));
  }
  if (c.tension == P::Tension::akinci2013) on_samples(w.akinci2012, akinci2013_adhesion(f, w));
}

template <int D, class B>
std::unique_ptr<NonPressureForces<D, B>> make_forces_on(const EngineInput& in) {
  const SceneKernel<D> W(Real(in.derived.support_radius), kernel_order(in.scene));
  const ForceParameters<D> c = force_parameters<D>(in.scene, in.derived);
  if (!c.any()) return nullptr;
  return std::make_unique<Forces<D, B, SceneKernel>>(c, W);
}

}  // namespace FRESHET_ISA
}  // namespace freshet
