// SPDX-License-Identifier: MIT
#pragma once
#include "solvers/incompressible.h"

namespace freshet {
inline namespace FRESHET_ISA {

template <int D> struct PbfFluid : IncompressibleFluid<D> {
  Field<Real> lambda;   ///< scratch: -lambda_i/(m rho0) of the iteration [m^5/kg]
  Field<Vec<D>> moved;  ///< scratch: sum of the corrections of the step [m]
  template <class Visit> void fields(Visit visit) {
    IncompressibleFluid<D>::fields(visit);
    visit("lambda", Keep::scratch, lambda);
    visit("moved", Keep::scratch, moved);
  }
};

/// Position based fluids [Macklin and Mueller 2013], algorithm 1. Particles move without pressure,
/// then corrections of their positions remove compression. The corrections over dt are the change
/// of velocity. Pressures are not negative, so the artificial pressure of the paper's sec. 4 is not
/// needed.
template <int D, Backend<D> B, template <int> class Kernel>
struct Pbf : Incompressible<D, B, Kernel> {
  using Base = Incompressible<D, B, Kernel>;
  using Base::c;
  using Fluid = PbfFluid<D>;

  std::array<Solve, 1> step(B& backend, Fluid& fluid, Walls<D>& w, const Tick& t) const {
    const Real dt = t.dt;
    predict(backend, fluid, dt);  // lines 1 to 4
    if (w.bodies) predict_bodies(backend, w, dt);
    this->find_neighbors(backend, fluid, w);
    const auto f = fluid;
    backend.for_each("start", f, [=] FRESHET_LAMBDA(int i) {
      f.k[i] = 0;
      f.moved[i] = Vec<D>{};
    });
    const Solve density = solve(
        "density", c.density, [&] { return constrain(backend, f, w); },  // eqs. 1 and 11
        [&](double) { correct(backend, f, w, dt); });                    // eq. 12
    const Vec<D> g = c.gravity;
    const auto confine = c.confine;
    backend.for_each("kick", f, [=] FRESHET_LAMBDA(int i) {
      f.v[i] += f.moved[i] / dt;  // line 21
      f.p[i] = f.k[i] * square(f.rho[i]);
    });
    this->push_without_pressure(backend, f, w, dt, Vec<D>{});  // line 22: eq. 17
    backend.for_each("kick", f, [=] FRESHET_LAMBDA(int i) {
      f.a[i] += g + f.moved[i] / (dt * dt);
      confine(i, f, f.v[i], f.x[i] - f.moved[i]);
    });
    return {density};
  }

  // The parts of a step: public for nvcc, which takes no lambdas from private functions.
  void predict(B& backend, const Fluid& fluid, Real dt) const {
    const auto f = fluid;
    const Vec<D> g = c.gravity;
    const auto confine = c.confine;
    backend.for_each("predict", f, [=] FRESHET_LAMBDA(int i) {
      f.v[i] += dt * g;
      const Vec<D> from = f.x[i];
      f.x[i] += dt * f.v[i];
      confine(i, f, f.v[i], from);
    });
  }

  /// Computes the density at the corrected positions and the multipliers lambda. Returns the error.
  double constrain(B& backend, const Fluid& fluid, const Walls<D>& w) const {
    const auto f = fluid;
    const Real rho0 = c.rho0, omega = c.relaxation(1);
    this->density_and_factor(backend, f, w, "solve: rate");
    backend.for_each("solve: lambda", f, [=] FRESHET_LAMBDA(int i) {
      f.excess[i] = max(f.rho[i] - rho0, Real(0));
      f.lambda[i] = omega * f.excess[i] * f.factor[i];
    });
    return this->error(backend, f);
  }

  /// Moves body particles by dt^2 pull, the displacement by gravity and other loads. The engine has
  /// already moved them by the bodies' velocity over dt.
  void predict_bodies(B& backend, const Walls<D>& w, Real dt) const {
    BodyCoupling<D>::displace(backend, w,
                              [=](const auto& body) { return square(double(dt)) * body.pull; });
    for (auto& body : w.bodies->all) body.motion += double(dt) * std::exchange(body.pull, {});
  }
  /// Corrects the positions of bodies by lambda and adds the impulse of the correction.
  void correct_bodies(B& backend, const Fluid& f, const Walls<D>& w, Real dt) const {
    this->press_bodies(backend, f, w, f.lambda);
    this->note_impulse(w, 1 / double(dt));
    if (!w.bodies->respond) return;
    for (auto& body : w.bodies->all) body.motion += 1 / double(dt) * body.push;
    BodyCoupling<D>::displace(backend, w, [](const auto& body) { return body.push; });
  }

  void correct(B& backend, const Fluid& fluid, const Walls<D>& w, Real dt) const {
    const auto f = fluid;
    if (w.bodies) correct_bodies(backend, f, w, dt);  // before x changes
    this->pressure_acceleration(backend, f, w, f.lambda, [=] FRESHET_LAMBDA(int i, Vec<D> sum) {
      f.moved[i] += sum;
      f.x[i] += sum;
      f.k[i] += f.lambda[i] / (dt * dt);
    });
    backend.share("x", f, f.x);
  }
};

}  // namespace FRESHET_ISA
}  // namespace freshet
