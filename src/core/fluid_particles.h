// SPDX-License-Identifier: MIT
/// What every solver's fluid has, and the liquids that its particles are of.
#pragma once
#include "core/field.h"

namespace freshet {
inline namespace FRESHET_ISA {

template <int D> struct FluidParticles : Particles<D> {
  Field<Vec<D>> a;     ///< acceleration [m/s^2]
  Field<Real> rho, p;  ///< density as if all were the densest liquid [kg/m^D], pressure [Pa]
  Field<int> kind;     ///< kept: number of the liquid; no memory where there is but one
  FRESHET_HD int liquid(int i) const { return kind.data ? kind[i] : 0; }
};

/// A liquid beside the densest, whose rest density is rho0.
struct Liquid {
  Real lightness = 1;  ///< rho0 over its own rest density, >= 1
  Real nu = 0;         ///< its dynamic viscosity over rho0 [m^2/s]
};

/// The liquids of a scene. Several have volumes in common, not masses [Solenthaler and Pajarola
/// 2008, eqs. 5 to 9]: with s = V sum_j W_ij and p of the same s for all, dv_i/dt =
/// -V/rho0_i sum_j (p_i/s_i^2 + p_j/s_j^2) grad W_ij. So all of them compute with rho = rho0 s and
/// m = rho0 V of the densest, and only what a force comes to at last asks for a particle's liquid:
/// it accelerates one by its lightness more.
struct Liquids {
  static constexpr int most = 8;
  Liquid liquid[most];
  FRESHET_HD const Liquid& operator[](int kind) const { return liquid[kind]; }
  template <int D> FRESHET_HD Real lightness(const FluidParticles<D>& f, int i) const {
    return liquid[f.liquid(i)].lightness;
  }
  template <int D> FRESHET_HD Real nu(const FluidParticles<D>& f, int i) const {
    return liquid[f.liquid(i)].nu;
  }
};

}  // namespace FRESHET_ISA
}  // namespace freshet
