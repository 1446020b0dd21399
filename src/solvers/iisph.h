// SPDX-License-Identifier: MIT
#pragma once
#include "solvers/incompressible.h"

namespace freshet {
inline namespace FRESHET_ISA {

template <int D> struct IisphFluid : IncompressibleFluid<D> {
  Field<Real> rise;   ///< scratch: excess density predicted without pressure [kg/m^3]
  Field<Vec<D>> a_p;  ///< scratch: acceleration by the pressures [m/s^2]
  template <class Visit> void fields(Visit visit) {
    IncompressibleFluid<D>::fields(visit);
    visit("rise", Keep::scratch, rise);
    visit("a_p", Keep::scratch, a_p);
  }
};

/// Implicit incompressible SPH [Ihmsen, Cornelis, Solenthaler, Horvath, Teschner 2014], algorithm
/// 1. A relaxed Jacobi iteration finds pressures p >= 0, here k = p/rho^2, that give every particle
/// its rest density. The paper's sums of d_ij p_j are the accelerations by the pressures. The
/// product with the matrix is the density rate by these accelerations.
template <int D, Backend<D> B, template <int> class Kernel>
struct Iisph : Incompressible<D, B, Kernel> {
  using Base = Incompressible<D, B, Kernel>;
  using Base::c;
  using Fluid = IisphFluid<D>;
  using typename Base::Twist;

  std::array<Solve, 1> step(B& backend, Fluid& fluid, Walls<D>& w, const Tick& t) const {
    this->find_neighbors(backend, fluid, w);
    const auto f = fluid;
    const Real dt = t.dt, start = c.warm_start ? Real(0.5f) : 0;
    this->density_and_factor(backend, f, w);
    this->push_without_pressure(backend, f, w, dt, c.gravity);  // v_adv
    this->density_rate(backend, f, w, f.v, [=] FRESHET_LAMBDA(int i, Real rate) {
      f.rise[i] = f.to_remove[i] + dt * rate;  // eq. 4
      f.k[i] = start * f.k[i];
    });
    if (w.bodies && !w.bodies->respond)  // pressures do not accelerate them
      this->show_bodies(backend, f, w, [](const auto&) { return Twist{}; });
    const Solve density = solve(
        "density", c.density, [&] { return iterate(backend, f, w, dt); }, [](double) {});
    this->note_impulse(backend, f, w, f.k, dt);
    this->pressure_acceleration(backend, f, w, f.k, [=] FRESHET_LAMBDA(int i, Vec<D> a) {
      f.a[i] += a;
      f.v[i] += dt * a;  // eq. 15
    });
    this->drift(backend, f, dt, f.v);
    return {density};
  }

  // Public for nvcc, which takes no lambdas from private functions.
  /// One iteration of the pressures. Returns the error before it.
  double iterate(B& backend, const Fluid& fluid, const Walls<D>& w, Real dt) const {
    const auto f = fluid;
    const Real dt2 = dt * dt, omega = c.relaxation(0.5f);
    this->pressure_acceleration(backend, f, w, f.k,
                                [=] FRESHET_LAMBDA(int i, Vec<D> a) { f.a_p[i] = a; });
    backend.share("a_p", f, f.a_p);
    if (w.bodies && w.bodies->respond) {
      this->press_bodies(backend, f, w, f.k);
      this->show_bodies(backend, f, w, [](const auto& body) { return body.push; });
    }
    this->density_rate(backend, f, w, f.a_p, [=] FRESHET_LAMBDA(int i, Real rate) {
      const Real excess = f.rise[i] + dt2 * rate, k_per_excess = f.factor[i] / dt2;
      f.excess[i] = Base::left_of(excess, f.k[i], k_per_excess);
      f.k[i] = max(f.k[i] + omega * k_per_excess * excess, Real(0));  // eq. 13
    });
    return this->error(backend, f);
  }
};

}  // namespace FRESHET_ISA
}  // namespace freshet
