// SPDX-License-Identifier: MIT
#pragma once
#include "solvers/incompressible.h"

namespace freshet {
inline namespace FRESHET_ISA {

template <int D> struct DfsphFluid : IncompressibleFluid<D> {
  Field<Real> k_other;              ///< kept: k of the solve whose pressures are not the fluid's
  Field<Real> change, k_before;     ///< scratch: change of k; k of the previous iteration
  Field<Vec<D>> v_before, v_start;  ///< scratch: v of the previous iteration, and before a stage
  template <class Visit> void fields(Visit visit) {
    IncompressibleFluid<D>::fields(visit);
    visit("k_other", Keep::kept, k_other);
    visit("change", Keep::scratch, change);
    visit("k_before", Keep::scratch, k_before);
    visit("v_before", Keep::scratch, v_before);
    visit("v_start", Keep::scratch, v_start);
  }
};

/// Divergence-free SPH for incompressible and viscous fluids [Bender and Koschier 2017]. One solve
/// keeps the velocity divergence-free, the other keeps the density.
///
/// In the paper both solves change the velocity. With `gradual` [Hu and Adams 2007] the divergence
/// solve comes after all other forces, also removes a part of the density's error, and its
/// pressures are those of the fluid. The density solve moves particles and leaves their velocities;
/// it has work to do in the moments after impacts alone.
///
/// Both solve a complementarity problem: pressures k >= 0, no positive excess, and k = 0 where the
/// excess is negative. An iteration is a relaxed Jacobi step. With `accelerated` it adds momentum
/// along the previous change [Nesterov 1983], which restarts when the error grows [O'Donoghue and
/// Candes 2015]. The depth to which pressure has spread from the surface then grows with the number
/// of iterations, not with its square root.
template <int D, Backend<D> B, template <int> class Kernel>
struct Dfsph : Incompressible<D, B, Kernel> {
  using Base = Incompressible<D, B, Kernel>;
  using Base::c;
  using Fluid = DfsphFluid<D>;

  std::array<Solve, 2> step(B& backend, Fluid& fluid, Walls<D>& w, const Tick& t) const {
    this->find_neighbors(backend, fluid, w);
    const auto f = fluid;
    this->density_and_factor(backend, f, w);
    backend.for_each("start", f, [=] FRESHET_LAMBDA(int i) { f.v_start[i] = f.v[i]; });
    return c.gradual ? step_of_hu_and_adams(backend, f, w, t.dt)
                     : step_of_bender_and_koschier(backend, f, w, t.dt);
  }

  /// Algorithm 1, from the divergence solve on.
  std::array<Solve, 2> step_of_bender_and_koschier(B& backend, const Fluid& fluid,
                                                   const Walls<D>& w, Real dt) const {
    const auto f = fluid;
    const Solve divergence =  // algorithm 2; Excess ignores particles with few neighbours
        remove(backend, f, w, "divergence", f.k_other, c.divergence, Excess{f.rho, c.rho0, dt});
    this->push_without_pressure(backend, f, w, dt, c.gravity);
    const Solve density =  // algorithm 3
        remove(backend, f, w, "density", f.k, c.density, Excess{f.rho, c.rho0, dt, f.to_remove});
    backend.for_each("start", f,
                     [=] FRESHET_LAMBDA(int i) { f.a[i] = (f.v[i] - f.v_start[i]) / dt; });
    this->drift(backend, f, dt, f.v);
    return {divergence, density};
  }

  /// The density solve starts from pressures of zero. Bodies do not respond to it.
  std::array<Solve, 2> step_of_hu_and_adams(B& backend, const Fluid& fluid, const Walls<D>& w,
                                            Real dt) const {
    const auto f = fluid;
    const bool at_rest = is_almost_at_rest(backend, f);
    this->push_without_pressure(backend, f, w, dt, c.gravity);
    const Solve divergence =
        remove(backend, f, w, "divergence", f.k, at_rest ? c.divergence_at_rest : c.divergence,
               Excess{f.rho, c.rho0, dt, f.to_remove});
    const Real rho0 = c.rho0;
    backend.for_each("start", f, [=] FRESHET_LAMBDA(int i) {
      f.to_remove[i] = f.rho[i] - rho0;
      f.a[i] = (f.v[i] - f.v_start[i]) / dt;
      f.v_start[i] = f.v[i];
      f.k_other[i] = 0;
    });
    const bool respond = w.bodies && std::exchange(w.bodies->respond, false);
    const Solve density = iterate(backend, f, w, "density", f.k_other, c.density,
                                  Excess{f.rho, c.rho0, dt, f.to_remove});
    if (respond) w.bodies->respond = true;
    this->drift(backend, f, dt, f.v_start);
    return {divergence, density};
  }

  /// The excess that a solve removes, a function of the rate Drho_i/Dt [kg/m^3]: to_remove + dt
  /// Drho/Dt. Without to_remove it is that of the paper's divergence solve: dt Drho/Dt, and a
  /// particle with rho <= 0.6 rho0, at a free surface, has no positive excess.
  struct Excess {
    Field<Real> rho;
    Real rho0, dt;
    Field<Real> to_remove{};
    FRESHET_HD Real operator()(int i, Real rate) const {
      if (to_remove.data) return to_remove[i] + dt * rate;
      return rho[i] > Real(0.6f) * rho0 ? dt * rate : min(dt * rate, Real(0));
    }
  };

  // The parts of a step: public for nvcc, which takes no lambdas from private functions.
  /// Whether the root mean square of the speed is below 0.04 sqrt(g h). There a warm start is often
  /// within the tolerance as it is; the pressures then follow the motion too late, and feed it.
  bool is_almost_at_rest(B& backend, const Fluid& f) const {
    const double v2 = backend.sum("start", f, [=] FRESHET_LAMBDA(int i) { return norm2(f.v[i]); });
    return v2 < 0.0016 * double(norm(c.gravity)) * double(c.h) * f.n;
  }
  /// Solves for pressures k that remove the excess, and changes v by them.
  Solve remove(B& backend, const Fluid& f, const Walls<D>& w, const char* name, Field<Real> k,
               const Iterations& limits, const Excess& excess) const {
    start(backend, f, w, k, excess.dt);
    const Solve done = iterate(backend, f, w, name, k, limits, excess);
    this->note_impulse(backend, f, w, k, excess.dt);
    forget_unneeded(backend, f, k, excess.dt);
    return done;
  }
  Solve iterate(B& backend, const Fluid& f, const Walls<D>& w, const char* name, Field<Real> k,
                const Iterations& limits, const Excess& excess) const {
    Momentum momentum(c.accelerated);
    return solve(
        name, limits, [&] { return measure(backend, f, w, k, excess); },
        [&](double error) { improve(backend, f, w, k, excess.dt, Real(momentum.next(error))); });
  }

  /// Resets pressures of which less than half was needed. With a warm start from them, particles
  /// that fly apart would be pushed further in every step, by less than the tolerance.
  void forget_unneeded(B& backend, const Fluid& fluid, Field<Real> k, Real dt) const {
    const auto f = fluid;
    backend.for_each("start", f, [=] FRESHET_LAMBDA(int i) {
      if (k[i] + 2 * f.excess[i] * f.factor[i] / (dt * dt) < 0) k[i] = 0;
    });
  }

  /// Initialises k: with a warm start from the previous step, whose pressures push v, else from
  /// zero.
  void start(B& backend, const Fluid& fluid, const Walls<D>& w, Field<Real> k, Real dt) const {
    const auto f = fluid;
    const double most = backend.max(
        "start", f, [=] FRESHET_LAMBDA(int i) { return double(k[i] < 0 ? -k[i] : k[i]); });
    if (c.warm_start && most > 0)
      this->pressure_acceleration(backend, f, w, k,
                                  [=] FRESHET_LAMBDA(int i, Vec<D> a) { f.v[i] += dt * a; });
    else backend.for_each("start", f, [=] FRESHET_LAMBDA(int i) { k[i] = 0; });
    this->share_for_rate(backend, f);
    if (w.bodies && w.bodies->respond) push_bodies(backend, f, w, k, dt, 0);
  }

  /// Computes the change of k by one Jacobi step. Returns the error before it.
  double measure(B& backend, const Fluid& fluid, const Walls<D>& w, Field<Real> k,
                 const Excess& excess_of) const {
    const auto f = fluid;
    const Real dt = excess_of.dt;
    // With momentum a relaxation factor below 4/(3 stiffness) converges.
    const Real omega = c.accelerated ? Real(1.2f) / c.stiffness : c.relaxation(0.5f);
    this->density_rate(backend, f, w, f.v, [=] FRESHET_LAMBDA(int i, Real rate) {
      const Real excess = excess_of(i, rate), k_per_excess = f.factor[i] / (dt * dt);  // eq. 12
      f.change[i] = max(k[i] + omega * k_per_excess * excess, Real(0)) - k[i];
      f.excess[i] = Base::left_of(excess, k[i], k_per_excess);
    });
    return this->error(backend, f);
  }

  /// Adds the change to k and its push to v, then extrapolates both by beta times their difference
  /// from the previous iteration.
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
    this->share_for_rate(backend, f);
  }

  /// Applies one iteration to the motion of bodies: the push of `change`, then extrapolation by
  /// beta.
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

  /// beta of Nesterov's scheme; 0 for plain Jacobi. theta starts at 3, its value after a few
  /// iterations, because a warm start is close to the solution.
  class Momentum {
   public:
    explicit Momentum(bool on) : on_(on) {}
    double next(double error) {
      if (!on_) return 0;
      const bool first = last_error_ < 0;  // there is no previous change yet
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
