// SPDX-License-Identifier: MIT
/// The fluid fields that all solvers share, and the liquids of a scene.
#pragma once
#include "core/field.h"

namespace freshet {
inline namespace FRESHET_ISA {

template <int D> struct FluidParticles : Particles<D> {
  Field<Vec<D>> a;     ///< acceleration [m/s^2]
  Field<Real> rho, p;  ///< density scaled to the densest liquid [kg/m^3], pressure [Pa]
  Field<int> kind;     ///< kept: index of the liquid; no memory for one liquid
  FRESHET_HD int liquid(int i) const { return kind.data ? kind[i] : 0; }
};

/// A liquid relative to the densest liquid, whose rest density is rho0.
struct Liquid {
  Real lightness = 1;        ///< rho0 over its own rest density, >= 1
  Real nu = 0;               ///< its dynamic viscosity over rho0 [m^2/s]
  Real mu = 0;               ///< dynamic viscosity [Pa s]
  Real sigma = 0;            ///< surface tension [N/m]
  Real gamma = 0, beta = 0;  ///< of Akinci 2013: cohesion, adhesion [m/s^2]
};

/// One number of the liquids, by particle. `kind` has no memory where there is one liquid.
struct PerLiquid {
  static constexpr int most = 8;
  Real of[most];
  Field<int> kind;
  FRESHET_HD Real operator[](int i) const { return of[kind.data ? kind[i] : 0]; }
};

/// The liquids of a scene. Their particles have equal volumes V, not equal masses [Solenthaler and
/// Pajarola 2008, eqs. 5 to 9]. With s = V sum_j W_ij and p a function of s for all liquids,
///
///   dv_i/dt = -V/rho0_i sum_j (p_i/s_i^2 + p_j/s_j^2) grad W_ij
///
/// All particles therefore compute with rho = rho0 s and m = rho0 V of the densest liquid. The
/// resulting acceleration is multiplied by the lightness of the particle's liquid.
struct Liquids {
  static constexpr int most = PerLiquid::most;
  Liquid liquid[most];
  int count = 1;
  FRESHET_HD const Liquid& operator[](int kind) const { return liquid[kind]; }
  template <int D> FRESHET_HD Real lightness(const FluidParticles<D>& f, int i) const {
    return liquid[f.liquid(i)].lightness;
  }
  template <int D> FRESHET_HD Real nu(const FluidParticles<D>& f, int i) const {
    return liquid[f.liquid(i)].nu;
  }
  /// `number` of each liquid, by the particles of f.
  template <int D> PerLiquid each(Real Liquid::*number, const FluidParticles<D>& f) const {
    PerLiquid table{{}, f.kind};
    for (int k = 0; k < most; ++k) table.of[k] = liquid[k].*number;
    return table;
  }
};

}  // namespace FRESHET_ISA
}  // namespace freshet
