// SPDX-License-Identifier: MIT
#pragma once
#include "solvers/incompressible.h"

namespace freshet {
inline namespace FRESHET_ISA {

template <int D> struct DfsphFluid : IncompressibleFluid<D> {
  Field<Real> k_divergence;         ///< kept: p/rho^2 of the divergence's solve
  Field<Real> change, k_before;     ///< scratch: of the iteration
  Field<Vec<D>> v_before, v_start;  ///< scratch: of the iteration; of the step
  template <class Visit> void fields(Visit visit) {
    IncompressibleFluid<D>::fields(visit);
    visit("k_divergence", Keep::kept, k_divergence);
    visit("change", Keep::scratch, change);
    visit("k_before", Keep::scratch, k_before);
    visit("v_before", Keep::scratch, v_before);
    visit("v_start", Keep::scratch, v_start);
  }
};

/// Divergence-free SPH for incompressible and viscous fluids [Bender and Koschier 2017]: one solve
/// for pressures that keep the velocities free of divergence, one for pressures that keep the
/// density, each started from the pressures of the step before.
///
/// Both seek pressures k >= 0 that leave nothing compressed, and push nothing apart that is not. An
/// iteration is a step of Jacobi's towards them, and with `accelerated` a further one along the
/// last step, longer from iteration to iteration [Nesterov 1983], started over where the error grew
/// [O'Donoghue and Candes 2015]: the depth that the pressure of the surface has reached then grows
/// with the iterations, not with their root.
template <int D, Backend<D> B, template <int> class Kernel>
struct Dfsph : Incompressible<D, B, Kernel> {
  using Base = Incompressible<D, B, Kernel>;
  using Base::c;
  using Fluid = DfsphFluid<D>;

  /// Algorithm 1, from the search on.
  std::array<Solve, 2> step(B& backend, Fluid& fluid, Walls<D>& w, const Tick& t) const {
    this->find_neighbors(backend, fluid, w);
    const auto f = fluid;
    const Real dt = t.dt;
    this->density_and_factor(backend, f, w);
    backend.for_each("start", f, [=] FRESHET_LAMBDA(int i) { f.v_start[i] = f.v[i]; });
    const Solve divergence =  // algorithm 2; the surface's few neighbours are no divergence
        remove(backend, f, w, "divergence", f.k_divergence, c.divergence,
               {f.rho, c.rho0, dt, true});
    this->push_without_pressure(backend, f, w, dt, c.gravity);
    const Solve density =  // algorithm 3
        remove(backend, f, w, "density", f.k, c.density, {f.rho, c.rho0, dt, false});
    backend.for_each("start", f,
                     [=] FRESHET_LAMBDA(int i) { f.a[i] = (f.v[i] - f.v_start[i]) / dt; });
    this->drift(backend, f, dt);
    return {divergence, density};
  }

  /// What a solve removes, by the rate Drho_i/Dt [kg/m^D].
  struct Excess {
    Field<Real> rho;
    Real rho0, dt;
    bool of_divergence;  ///< dt Drho/Dt, else rho - rho0 + dt Drho/Dt
    FRESHET_HD Real operator()(int i, Real rate) const {
      if (!of_divergence) return rho[i] - rho0 + dt * rate;
      return rho[i] > Real(0.6f) * rho0 ? dt * rate : min(dt * rate, Real(0));
    }
  };

  // The parts of a step: public for nvcc, which takes no lambdas from private functions.
  /// Changes v by pressures k until the excess is gone.
  Solve remove(B& backend, const Fluid& f, const Walls<D>& w, const char* name, Field<Real> k,
               const Iterations& limits, const Excess& excess) const {
    const Real dt = excess.dt;
    Momentum momentum(c.accelerated);
    start(backend, f, w, k, dt);
    const Solve done = solve(
        name, limits, [&] { return measure(backend, f, w, k, excess); },
        [&](double error) { improve(backend, f, w, k, dt, Real(momentum.next(error))); });
    this->note_impulse(backend, f, w, k, dt);
    forget_unneeded(backend, f, k, dt);
    return done;
  }

  /// Pressures of which less than half was needed are not started from again: what flies apart
  /// would be pushed on, step by step, by no more than the tolerance.
  void forget_unneeded(B& backend, const Fluid& fluid, Field<Real> k, Real dt) const {
    const auto f = fluid;
    backend.for_each("start", f, [=] FRESHET_LAMBDA(int i) {
      if (k[i] + 2 * f.excess[i] * f.factor[i] / (dt * dt) < 0) k[i] = 0;
    });
  }

  /// v pushed by the pressures of the step before; or by none, from zero on.
  void start(B& backend, const Fluid& fluid, const Walls<D>& w, Field<Real> k, Real dt) const {
    const auto f = fluid;
    const double most = backend.max(
        "start", f, [=] FRESHET_LAMBDA(int i) { return double(k[i] < 0 ? -k[i] : k[i]); });
    if (c.warm_start && most > 0)
      this->pressure_acceleration(backend, f, w, k,
                                  [=] FRESHET_LAMBDA(int i, Vec<D> a) { f.v[i] += dt * a; });
    else backend.for_each("start", f, [=] FRESHET_LAMBDA(int i) { k[i] = 0; });
    backend.share("v", f, f.v);
    if (w.bodies && w.bodies->respond) push_bodies(backend, f, w, k, dt, 0);
  }

  /// The change of k that Jacobi's step is, and the error before it.
  double measure(B& backend, const Fluid& fluid, const Walls<D>& w, Field<Real> k,
                 const Excess& excess_of) const {
    const auto f = fluid;
    const Real dt = excess_of.dt;
    // With momentum steps converge that are shorter than 4/(3 stiffness).
    const Real omega = c.accelerated ? Real(1.2f) / c.stiffness : c.relaxation(0.5f);
    this->density_rate(backend, f, w, f.v, [=] FRESHET_LAMBDA(int i, Real rate) {
      const Real excess = excess_of(i, rate), k_per_excess = f.factor[i] / (dt * dt);  // eq. 12
      f.change[i] = max(k[i] + omega * k_per_excess * excess, Real(0)) - k[i];
      f.excess[i] = Base::left_of(excess, k[i], k_per_excess);
    });
    return this->error(backend, f);
  }

  /// k + change, v pushed by the change, and both on by beta times what they went since the last.
  void improve(B& backend, const Fluid& fluid, const Walls<D>& w, Field<Real> k, Real dt,
               Real beta) const {
    const auto f = fluid;
    if (w.bodies && w.bodies->respond) push_bodies(backend, f, w, f.change, dt, beta);
    this->pressure_acceleration(backend, f, w, f.change, [=] FRESHET_LAMBDA(int i, Vec<D> a) {
      const Real k_next = k[i] + f.change[i];
      const Vec<D> v_next = f.v[i] + dt * a;
      k[i] = k_next + beta * (k_next - f.k_before[i]);
      f.v[i] = v_next + beta * (v_next - f.v_before[i]);
      f.k_before[i] = k_next;
      f.v_before[i] = v_next;
    });
    backend.share("v", f, f.v);
  }

  /// The same of the motion of bodies.
  void push_bodies(B& backend, const Fluid& f, const Walls<D>& w, Field<Real> change, Real dt,
                   Real beta) const {
    this->press_bodies(backend, f, w, change);
    for (auto& body : w.bodies->all) {
      const auto next = body.motion + double(dt) * body.push;
      body.motion = next + double(beta) * (next - body.before);
      body.before = next;
    }
    this->show_bodies(backend, f, w);
  }

  /// beta of Nesterov's scheme, as if a few iterations had gone before: the pressures it starts
  /// from are nearly right. Of Jacobi's own 0.
  class Momentum {
   public:
    explicit Momentum(bool on) : on_(on) {}
    double next(double error) {
      if (!on_) return 0;
      const bool first = last_error_ < 0;  // no change to go on along
      if (!first && error > last_error_) theta_ = 1;
      last_error_ = error;
      const double before = std::exchange(theta_, (1 + std::sqrt(1 + 4 * theta_ * theta_)) / 2);
      return first ? 0 : (before - 1) / theta_;
    }

   private:
    bool on_;
    double theta_ = 3, last_error_ = -1;
  };
};

}  // namespace FRESHET_ISA
}  // namespace freshet
