// SPDX-License-Identifier: MIT
#pragma once
#include "pairs/predicted_density.h"
#include "solvers/incompressible.h"

namespace freshet {
inline namespace FRESHET_ISA {

template <int D> struct PcisphFluid : IncompressibleFluid<D> {
  Field<Vec<D>> a_p;    ///< scratch: acceleration by the pressures [m/s^2]
  Field<Vec<D>> moved;  ///< scratch: x* - x [m]
  template <class Visit> void fields(Visit visit) {
    IncompressibleFluid<D>::fields(visit);
    visit("a_p", Keep::scratch, a_p);
    visit("moved", Keep::scratch, moved);
  }
};

/// Predictive-corrective incompressible SPH [Solenthaler and Pajarola 2009], algorithm 2. An
/// iteration predicts the positions and corrects the pressures by the density there. Pressures
/// start from zero.
template <int D, Backend<D> B, template <int> class Kernel>
struct Pcisph : Incompressible<D, B, Kernel> {
  using Base = Incompressible<D, B, Kernel>;
  using Base::c;
  using Base::W;
  using Fluid = PcisphFluid<D>;

  std::array<Solve, 1> step(B& backend, Fluid& fluid, Walls<D>& w, const Tick& t) const {
    this->find_neighbors(backend, fluid, w);
    const auto f = fluid;
    const Real dt = t.dt;
    this->density_and_factor(backend, f, w);
    this->push_without_pressure(backend, f, w, dt, c.gravity);
    backend.for_each("start", f, [=] FRESHET_LAMBDA(int i) {
      f.k[i] = 0;
      f.a_p[i] = Vec<D>{};
    });
    const Solve density = solve(
        "density", c.density, [&] { return correct(backend, f, w, dt); }, [](double) {});
    this->note_impulse(backend, f, w, f.k, dt);
    backend.for_each("kick", f, [=] FRESHET_LAMBDA(int i) {
      f.a[i] += f.a_p[i];
      f.v[i] += dt * f.a_p[i];
    });
    this->drift(backend, f, dt, f.v);
    return {density};
  }

  // The parts of a step: public for nvcc, which takes no lambdas from private functions.
  /// One iteration of the pressures. Returns the error before it.
  double correct(B& backend, const Fluid& fluid, const Walls<D>& w, Real dt) const {
    const auto f = fluid;
    const Real omega_dt2 = c.relaxation(0.5f) / (dt * dt), full = 1 / c.response;
    predict(backend, f, dt);
    backend.sum_pairs("solve: rate", f, over(f, PredictedDensity{W, c.m_density, f.moved}),
                      over(w.akinci2012, Akinci2012PredictedDensity{W, w.akinci2012.psi, f.moved,
                                                                    dt, w.akinci2012.v}),
                      [=] FRESHET_LAMBDA(int i, Real rho) {
                        const Real excess = rho - f.rho[i] + f.to_remove[i];
                        const Real delta = omega_dt2 * min(full, f.factor[i]);  // eq. 8
                        f.excess[i] = Base::left_of(excess, f.k[i], delta);
                        f.k[i] = max(f.k[i] + delta * excess, Real(0));  // eq. 9
                      });
    this->pressure_acceleration(backend, f, w, f.k,
                                [=] FRESHET_LAMBDA(int i, Vec<D> a) { f.a_p[i] = a; });
    if (w.bodies && w.bodies->respond) {
      this->press_bodies(backend, f, w, f.k);
      BodyCoupling<D>::set_velocities(
          backend, w, [=](const auto& body) { return body.motion + double(dt) * body.push; });
    }
    return this->error(backend, f);
  }

  void predict(B& backend, const Fluid& fluid, Real dt) const {
    const auto f = fluid;
    backend.for_each("solve: predict", f,
                     [=] FRESHET_LAMBDA(int i) { f.moved[i] = dt * (f.v[i] + dt * f.a_p[i]); });
    backend.share("moved", f, f.moved);
  }
};

}  // namespace FRESHET_ISA
}  // namespace freshet
