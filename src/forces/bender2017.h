// SPDX-License-Identifier: MIT
#pragma once
#include "forces/force.h"
#include "pairs/bender2017.h"

namespace freshet {
inline namespace FRESHET_ISA {

/// Turbulence by a micropolar fluid [Bender, Koschier, Kugelstadt, Weiler 2017]. Each particle has
/// an angular velocity omega:
///
///   Dv/Dt += nu_t curl omega,   Theta Domega/Dt = nu_t (curl v - 2 omega)  [eqs. 9 and 10]
///
/// The second equation is integrated by backward Euler in omega, which is stable for any nu_t.
///
///   nu_t [m^2/s], Theta [m^2]
template <int D, class B, template <int> class Kernel> struct Bender2017 final : Force<D, B> {
  using typename Force<D, B>::Fluid;
  Kernel<D> W;
  Real m, nu_t, Theta;
  Field<Spin<D, Real>> spin;  ///< kept: omega [1/s]
  Bender2017(const ForceParameters<D>& c, Kernel<D> W)
      : W(W), m(c.m), nu_t(c.nu_t), Theta(c.Theta) {}
  static bool acts(const ForceParameters<D>& c) {
    return c.vorticity == VorticityMethod::bender2017;
  }

  void add(B& backend, const Fluid& f, const Walls<D>&, Real dt, Field<Vec<D>> add) override {
    turn(backend, f, dt);
    push(backend, f, add);
  }
  void fields(FieldMaker<D>& maker) override { maker.make("spin", Keep::kept, spin); }

  // Public for nvcc, which takes no lambdas from private functions.
  /// add += nu_t curl omega  [m/s^2]
  void push(B& backend, const Fluid& fluid, Field<Vec<D>> add) const {
    const auto f = fluid;
    const Real factor = m * nu_t;
    backend.share("spin", f, spin);
    backend.sum_pairs("vorticity", f, over(f, Bender2017CurlSpin{W, spin, f.rho}),
                      [=] FRESHET_LAMBDA(int i, Vec<D> sum) { add[i] += factor * f.rho[i] * sum; });
  }
  /// Advances omega by dt [s].
  void turn(B& backend, const Fluid& fluid, Real dt) const {
    const auto f = fluid;
    const auto spin = this->spin;
    const Real rate = dt * nu_t / Theta, m = this->m;
    backend.sum_pairs("spin", f, over(f, Bender2017CurlV{W, f.v}),
                      [=] FRESHET_LAMBDA(int i, Spin<D, Real> sum) {
                        spin[i] = (1 / (1 + 2 * rate)) * (spin[i] + (rate * m / f.rho[i]) * sum);
                      });
  }
};

}  // namespace FRESHET_ISA
}  // namespace freshet
