// SPDX-License-Identifier: MIT
#pragma once
#include "core/field.h"
#include "kernels/spiky.h"
#include "kernels/viscosity.h"

namespace freshet {
inline namespace FRESHET_ISA {

/// The force densities of a particle [N/m^3].
template <int D, class R> struct ForceDensities {
  Vec<D, R> pressure{}, viscosity{};
  FRESHET_HD ForceDensities& operator+=(const ForceDensities& o) {
    pressure += o.pressure;
    viscosity += o.viscosity;
    return *this;
  }
};

/// f_i^pressure  = -sum_j m (p_i + p_j)/(2 rho_j) grad W_spiky(x_ij)      [Mueller 2003, eq. 10]
/// f_i^viscosity = mu sum_j m (v_j - v_i)/rho_j lap W_viscosity(x_ij)     [Mueller 2003, eq. 14]
///
/// The sums are force densities; divided by rho_i they are accelerations (eq. 8). The force on i
/// from j, m f_ij/rho_i, is then equal and opposite to that on j from i, so momentum is conserved.
///
///   m [kg/m^(3-D)], mu [Pa s];  reads p [Pa], rho [kg/m^3] (> 0), v [m/s]
template <int D> struct Mueller2003Forces {
  Spiky<D> W_spiky;
  ViscosityKernel<D> W_viscosity;
  Real m, mu;
  Field<Real> p, rho;
  Field<Vec<D>> v;

  template <class R> struct At {
    R p, rho;
    Vec<D, R> v;
  };
  template <class R> using Neighbor = At<R>;
  FRESHET_HD At<Real> at(int i) const { return {p[i], rho[i], v[i]}; }
  FRESHET_HD Neighbor<Real> neighbor(int j) const { return at(j); }
  template <class R>
  FRESHET_HD ForceDensities<D, R> operator()(const Pair<D, R>& ij, const At<R>& i,
                                             const At<R>& j) const {
    const R p_ij = (i.p + j.p) / (2 * j.rho);
    return {(-m * p_ij) * W_spiky.gradient(ij),
            (m * mu * W_viscosity.laplacian(ij) / j.rho) * (j.v - i.v)};
  }
};

}  // namespace FRESHET_ISA
}  // namespace freshet
