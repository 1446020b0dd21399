// SPDX-License-Identifier: MIT
/// The definitions of incompressible.h.
#pragma once
#include "solvers/incompressible.h"

namespace freshet {
inline namespace FRESHET_ISA {

/// Without sound the acoustic bound is the bound by the flow: a particle moves at most 0.4 h a
/// step.
template <int D, Backend<D> B, template <int> class Kernel>
TimeStepBounds Incompressible<D, B, Kernel>::bounds(B& backend, const BaseFluid& f) const {
  TimeStepBounds b = time_step_bounds(backend, f, double(c.h), 0, double(c.most_nu));
  std::swap(b.acoustic, b.flow);
  return b;
}

template <int D, Backend<D> B, template <int> class Kernel>
void Incompressible<D, B, Kernel>::find_neighbors(B& backend, BaseFluid& fluid,
                                                  const Walls<D>& w) const {
  backend.find_neighbors("neighbors", c.support, fluid, w.akinci2012, w.monaghan2009);
  if (fluid.kind.data) backend.share("kind", fluid, fluid.kind);
  if (!w.bodies) return;
  backend.list_neighbors("bodies", c.support, w.of_bodies, fluid);
  show_bodies(backend, fluid, w);
}

template <int D, Backend<D> B, template <int> class Kernel>
void Incompressible<D, B, Kernel>::density_and_factor(B& backend, const BaseFluid& fluid,
                                                      const Walls<D>& w, const char* name) const {
  const auto f = fluid;
  const auto c = this->c;
  backend.sum_pairs(name, f, over(f, FluidDensityAndResponse{W, c.m, c.m_density, c.liquids, f}),
                    over(w.akinci2012, Akinci2012DensityAndResponse{W, w.akinci2012.psi}),
                    [=] FRESHET_LAMBDA(int i, const DensityAndResponse<D, Real>& sum) {
                      const Real response = sum.response(c.liquids.lightness(f, i));
                      f.rho[i] = sum.rho;
                      f.factor[i] = response > Real(1e-3f) * c.response ? 1 / response : 0;
                      f.to_remove[i] = c.to_remove(sum.rho, sum.gradient);
                    });
  backend.share("rho", f, f.rho);
}

template <int D, Backend<D> B, template <int> class Kernel>
void Incompressible<D, B, Kernel>::push_without_pressure(B& backend, const BaseFluid& fluid,
                                                         const Walls<D>& w, Real dt,
                                                         Vec<D> g) const {
  const auto f = fluid;
  const Liquids liquids = c.liquids;
  backend.share("v", f, f.v);
  rub_bodies(backend, f, w);  // before v changes
  const auto accelerate = [=] FRESHET_LAMBDA(int i, Vec<D> sum) {
    f.a[i] = liquids.lightness(f, i) * sum + g;
    f.v[i] += dt * f.a[i];
  };
  if (c.most_nu > 0 || c.xsph > 0 || w.monaghan2009.n > 0)
    backend.sum_pairs("viscosity", f, over(f, fluid_friction(f, c.xsph_rate(dt))),
                      over(w.akinci2012, akinci2012_friction(f, w.akinci2012)),
                      over(w.monaghan2009, monaghan2009_forces(f, w)), accelerate);
  else backend.for_each("viscosity", f, [=] FRESHET_LAMBDA(int i) { accelerate(i, Vec<D>{}); });
  if (w.bodies) push_bodies(backend, f, w, dt);
  if (forces) forces->push(backend, f, w, dt);
  share_for_rate(backend, f);
}

template <int D, Backend<D> B, template <int> class Kernel>
void Incompressible<D, B, Kernel>::press_bodies(B& backend, const BaseFluid& f, const Walls<D>& w,
                                                Field<Real> k) const {
  backend.share("k", f, k);
  Coupling::sum_reactions(backend, w, f, akinci2012_forces(k, w.of_bodies));
  for (std::size_t b = 0; b < w.bodies->all.size(); ++b)
    w.bodies->all[b].push = w.bodies->all[b].answer(w.bodies->totals[b]);
}

template <int D, Backend<D> B, template <int> class Kernel>
void Incompressible<D, B, Kernel>::note_impulse(B& backend, const BaseFluid& f, const Walls<D>& w,
                                                Field<Real> k, Real dt) const {
  if (!w.bodies) return;
  backend.share("k", f, k);
  Coupling::sum_reactions(backend, w, f, akinci2012_forces(k, w.of_bodies));
  note_impulse(w, double(dt));
}

template <int D, Backend<D> B, template <int> class Kernel>
void Incompressible<D, B, Kernel>::set_rate(B& backend, const BaseFluid& f,
                                            const Walls<D>& w) const {
  Coupling::set_rate(backend, w, f, W);
}

template <int D, Backend<D> B, template <int> class Kernel>
void Incompressible<D, B, Kernel>::rub_bodies(B& backend, const BaseFluid& f,
                                              const Walls<D>& w) const {
  if (w.bodies) Coupling::sum_reactions(backend, w, f, akinci2012_friction(f, w.of_bodies));
}

template <int D, Backend<D> B, template <int> class Kernel>
void Incompressible<D, B, Kernel>::push_bodies(B& backend, const BaseFluid& f, const Walls<D>& w,
                                               Real dt) const {
  note_impulse(w, double(dt));
  if (!w.bodies->respond) return;
  for (std::size_t b = 0; b < w.bodies->all.size(); ++b) {
    Body& body = w.bodies->all[b];
    body.motion += double(dt) * (body.answer(w.bodies->totals[b]) + body.pull);
  }
  show_bodies(backend, f, w);
}

template <int D, Backend<D> B, template <int> class Kernel>
double Incompressible<D, B, Kernel>::error(B& backend, const BaseFluid& f) const {
  if (f.n == 0) return 0;
  const auto excess = f.excess;
  const double net =
      backend.sum("solve: error", f, [=] FRESHET_LAMBDA(int i) { return excess[i]; });
  const double all = backend.sum("solve: error", f, [=] FRESHET_LAMBDA(int i) {
    return excess[i] < 0 ? -excess[i] : excess[i];
  });
  return (all + std::abs(net)) / (2 * double(f.n) * double(c.rho0));
}

template <int D, Backend<D> B, template <int> class Kernel>
void Incompressible<D, B, Kernel>::drift(B& backend, const BaseFluid& fluid, Real dt,
                                         Field<Vec<D>> v_after) const {
  const auto f = fluid;
  const auto confine = c.confine;
  backend.for_each("drift", f, [=] FRESHET_LAMBDA(int i) {
    f.p[i] = f.k[i] * square(f.rho[i]);
    const Vec<D> from = f.x[i];
    f.x[i] += dt * f.v[i];
    f.v[i] = v_after[i];
    confine(i, f, f.v[i], from);
  });
}

}  // namespace FRESHET_ISA
}  // namespace freshet
