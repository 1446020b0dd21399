// SPDX-License-Identifier: MIT
#pragma once
#include "core/fluid_particles.h"

namespace freshet {
inline namespace FRESHET_ISA {

/// a_i = sum_j 2m/(rho_i + rho_j) (2 (D + 2) nu_ij (v_ij · x_ij)/(|x_ij|^2 + eps) grad W_ij
///                        - D xsph_rate (v_ij · x_ij)/(|x_ij|^2 + eps) x_ij W_ij),
/// nu_ij = 2 nu_i nu_j/(nu_i + nu_j)
///
/// The first part is nu lap v [Monaghan 2005, with the factor of a divergence-free flow in D
/// dimensions]. The second part moves each velocity toward those of its neighbours [Monaghan 1989;
/// XSPH in the form of Schechter and Bridson 2012], but along the line between the two particles
/// only: on average 1/D of the difference, hence the factor D. Rigid rotation has no such part, and
/// is kept. Both parts conserve momentum and angular momentum. The harmonic mean nu_ij makes the
/// stress equal on both sides of the interface of two liquids [Cleary and Monaghan 1999].
///
///   m [kg/m^(3-D)], nu [m^2/s], eps_h2 0.01 h^2 [m^2], xsph_rate [1/s]
///   reads rho [kg/m^3] (> 0), v [m/s];  the sum in m/s^2
template <int D, template <int> class Kernel> struct LaminarViscosity {
  Kernel<D> W;
  Real m;
  Liquids liquids;
  Real eps_h2, xsph_rate;
  static constexpr Real least_nu = 1e-30f;  ///< avoids 0/0 where both viscosities are zero
  FluidParticles<D> f;
  template <class R> struct At {
    R rho, nu;
    Vec<D, R> v;
  };
  template <class R> using Neighbor = At<R>;
  FRESHET_HD At<Real> at(int i) const { return {f.rho[i], liquids.nu(f, i), f.v[i]}; }
  FRESHET_HD Neighbor<Real> neighbor(int j) const { return at(j); }
  template <class R>
  FRESHET_HD Vec<D, R> operator()(const Pair<D, R>& ij, const At<R>& i, const At<R>& j) const {
    const Vec<D, R> v_ij = i.v - j.v;
    const R nu = 2 * i.nu * j.nu / max(i.nu + j.nu, R(least_nu));
    const R along = dot(v_ij, ij.x) / (ij.r2 + eps_h2);
    return (2 * m / (i.rho + j.rho) * along) *
           (2 * (D + 2) * nu * W.gradient(ij) - (D * xsph_rate * W(ij)) * ij.x);
  }
};
template <int D, template <int> class K, class... A>
LaminarViscosity(K<D>, A...) -> LaminarViscosity<D, K>;

/// a_i += sum_k psi_k friction_k/rho_i 2 (D + 2) nu_i (v_ik · x_ik)/(|x_ik|^2 + eps) grad W_ik
///
/// The viscosity of Monaghan 2005 at boundary particles of mass psi_k, density rho_i and viscosity
/// nu_i. There is no XSPH part.
///
///   psi [kg/m^(3-D)], friction 1 for no slip, 0 for free slip, eps_h2 0.01 h^2 [m^2]
///   reads rho [kg/m^3] (> 0), v, v_wall [m/s];  the sum in m/s^2
template <int D, template <int> class Kernel> struct Akinci2012Friction {
  Kernel<D> W;
  Liquids liquids;
  Real eps_h2;
  FluidParticles<D> f;
  Field<Real> psi, friction;
  Field<Vec<D>> v_wall;
  template <class R> struct At {
    R inv_rho, nu;
    Vec<D, R> v;
  };
  template <class R> struct Neighbor {
    R psi;
    Vec<D, R> v;
  };
  FRESHET_HD At<Real> at(int i) const { return {1 / f.rho[i], liquids.nu(f, i), f.v[i]}; }
  FRESHET_HD Neighbor<Real> neighbor(int k) const { return {psi[k] * friction[k], v_wall[k]}; }
  template <class R>
  FRESHET_HD Vec<D, R> operator()(const Pair<D, R>& ik, const At<R>& i,
                                  const Neighbor<R>& k) const {
    const R along = 2 * (D + 2) * i.nu * dot(i.v - k.v, ik.x) / (ik.r2 + eps_h2);
    return (k.psi * i.inv_rho * along) * W.gradient(ik);
  }
};
template <int D, template <int> class K, class... A>
Akinci2012Friction(K<D>, A...) -> Akinci2012Friction<D, K>;

}  // namespace FRESHET_ISA
}  // namespace freshet
