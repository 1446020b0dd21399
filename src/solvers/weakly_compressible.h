// SPDX-License-Identifier: MIT
/// What the weakly compressible solvers share: numbers, the equation of state, Adami's walls.
#pragma once
#include "boundary/confinement.h"
#include "freshet/time_step.h"
#include "pairs/adami2012.h"
#include "pairs/monaghan2009.h"
#include "solvers/integrators.h"
#include "solvers/wall_samples.h"

namespace freshet {
inline namespace FRESHET_ISA {

template <int D> struct WeaklyCompressibleParameters {
  Real support, h;    ///< support radius, half of it [m]
  Real m, m_density;  ///< mass [kg]; mass over the kernel's lattice sum [kg]
  Real rho0, c0;      ///< rest density [kg/m^D], speed of sound [m/s]
  Real alpha, delta;  ///< of artificial viscosity and of density diffusion
  Vec<D> gravity;     ///< [m/s^2]
  Confinement<D> confine;
  Integrator integrator;

  Real eps_h2() const { return Real(0.01f) * h * h; }
  /// B in p = B((rho/rho0)^7 - 1), so that sound has c0: B = rho0 c0^2/7
  Real B() const { return rho0 * c0 * c0 / 7; }
  /// K of the repulsive walls: (0.1 c0)^2, as c0 is ten times the fastest flow sqrt(2 g depth)
  Real repulsion() const { return square(Real(0.1f) * c0); }
};

/// p = B((rho/rho0)^7 - 1)  [Becker and Teschner 2007, eq. 7]
FRESHET_HD Real tait(Real B, Real rho_over_rho0) {
  const Real q = rho_over_rho0, q2 = q * q;
  return B * (q2 * q2 * q2 * q - 1);
}

/// p and v of Adami's wall particles. A wall pushes and never pulls.
template <int D, class B, class Kernel, class Fluid>
void extrapolate_to_walls(B& backend, const AdamiWall<D>& wall, const Fluid& f, const Kernel& W,
                          const WeaklyCompressibleParameters<D>& c) {
  if (wall.n == 0) return;
  backend.list_neighbors("walls", c.support, wall, f);
  const auto p = wall.p;
  const auto v = wall.v;
  backend.sum_pairs("walls", wall, over(f, Adami2012Extrapolation{W, c.gravity, f.p, f.rho, f.v}),
                    [=] FRESHET_LAMBDA(int w, const Adami2012Sums<D, Real>& sum) {
                      const bool wet = sum.W > 0;
                      p[w] = wet ? max((sum.p + sum.rho_x) / sum.W, Real(0)) : 0;
                      v[w] = wet ? Real(-1) / sum.W * sum.v : Vec<D>{};
                    });
}

}  // namespace FRESHET_ISA
}  // namespace freshet
