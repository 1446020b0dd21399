// SPDX-License-Identifier: MIT
#pragma once
#include "core/fluid_particles.h"

namespace freshet {
inline namespace FRESHET_ISA {

/// The density of a particle, and the sums of its response to its own pressure.
template <int D, class R> struct DensityAndResponse {
  R rho{}, gradient2{};  ///< sum_j m W_ij;  sum_j l_j |m grad W_ij|^2 over fluid particles
  Vec<D, R> gradient{};  ///< sum_j m grad W_ij
  FRESHET_HD DensityAndResponse& operator+=(const DensityAndResponse& o) {
    rho += o.rho;
    gradient2 += o.gradient2;
    gradient += o.gradient;
    return *this;
  }
  /// l_i |sum_j m grad W_ij|^2 + sum_j l_j |m grad W_ij|^2, l the lightness [kg^2/m^8]: the
  /// decrease of Drho_i/Dt per unit of p_i/rho_i^2 that acts for a unit of time [Bender and
  /// Koschier 2017, eq. 9: rho_i/alpha_i; Ihmsen 2014, eq. 12: -rho_i^2 a_ii/dt^2]
  FRESHET_HD R response(R l_i) const { return l_i * norm2(gradient) + gradient2; }
};

/// DensityAndResponse over fluid particles.
///
///   m  mass [kg/m^(3-D)];  m_density  mass over the kernel's lattice sum [kg/m^(3-D)]
template <int D, template <int> class Kernel> struct FluidDensityAndResponse {
  Kernel<D> W;
  Real m, m_density;
  Liquids liquids;
  FluidParticles<D> f;
  template <class R> using At = Nothing<R>;
  template <class R> struct Neighbor { R lightness; };
  FRESHET_HD At<Real> at(int) const { return {}; }
  FRESHET_HD Neighbor<Real> neighbor(int j) const { return {liquids.lightness(f, j)}; }
  template <class R>
  FRESHET_HD DensityAndResponse<D, R> operator()(const Pair<D, R>& ij, At<R>,
                                                 const Neighbor<R>& j) const {
    const Vec<D, R> gradient = m * W.gradient(ij);
    return {m_density * W(ij), j.lightness * norm2(gradient), gradient};
  }
};
template <int D, template <int> class K, class... A>
FluidDensityAndResponse(K<D>, A...) -> FluidDensityAndResponse<D, K>;

/// DensityAndResponse over boundary particles. They do not move and add nothing to gradient2.
///
///   psi [kg/m^(3-D)]
template <int D, template <int> class Kernel> struct Akinci2012DensityAndResponse {
  Kernel<D> W;
  Field<Real> psi;
  template <class R> using At = Nothing<R>;
  template <class R> struct Neighbor { R psi; };
  FRESHET_HD At<Real> at(int) const { return {}; }
  FRESHET_HD Neighbor<Real> neighbor(int k) const { return {psi[k]}; }
  template <class R>
  FRESHET_HD DensityAndResponse<D, R> operator()(const Pair<D, R>& ik, At<R>,
                                                 const Neighbor<R>& k) const {
    return {k.psi * W(ik), R(0), k.psi * W.gradient(ik)};
  }
};
template <int D, template <int> class K, class... A>
Akinci2012DensityAndResponse(K<D>, A...) -> Akinci2012DensityAndResponse<D, K>;

}  // namespace FRESHET_ISA
}  // namespace freshet
