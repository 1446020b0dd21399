// SPDX-License-Identifier: MIT
#pragma once
#include <cstdint>
#include <vector>

#include "core/field.h"

namespace freshet {
inline namespace FRESHET_ISA {

/// Rigid bodies during a step of a solver: their motion, their mobility and the places of their
/// body particles. Twists are about the centre of mass.
template <int D> struct RigidBodies {
  static constexpr int freedoms = D == 3 ? 6 : 3;
  /// Velocity and angular velocity, or force and torque, about the centre of mass: D linear
  /// components, then 1 (2D) or 3 (3D) angular ones.
  struct Twist {
    static constexpr int size = freedoms;
    double c[freedoms] = {};
    FRESHET_HD double operator[](int k) const { return c[k]; }
    FRESHET_HD double& operator[](int k) { return c[k]; }
    FRESHET_HD Twist& operator+=(const Twist& o) {
      for (int k = 0; k < freedoms; ++k) c[k] += o[k];
      return *this;
    }
    FRESHET_HD friend Twist operator*(double s, Twist t) {
      for (double& x : t.c) x *= s;
      return t;
    }
    FRESHET_HD friend Twist operator+(Twist a, const Twist& b) { return a += b; }
    FRESHET_HD friend Twist operator-(Twist a, const Twist& b) { return a += -1.0 * b; }
  };

  struct Body {
    Twist motion{};            ///< velocity of its particles [m/s, rad/s]
    Twist pull{};              ///< acceleration by gravity and similar loads [m/s^2, rad/s^2]
    Twist acceleration{};      ///< prescribed, or by the last force [m/s^2, rad/s^2]
    Twist impulse{};           ///< by the fluid in this step [N s, N m s; per m in 2D]
    Twist force{};             ///< by the fluid at its last evaluation [N, N m; per m in 2D]
    Twist force_before{};      ///< by the fluid at the evaluation before [N, N m; per m in 2D]
    Twist push{};              ///< scratch of a solve: response to its pressures
    Twist before{};            ///< scratch of a solve: motion at the previous iteration
    Twist mobility[freedoms];  ///< rows of the inverse mass matrix; zeros: nothing moves it
    /// The acceleration by a force and torque: mobility times `to`.
    Twist answer(const Twist& to) const {
      Twist a{};
      for (int i = 0; i < freedoms; ++i)
        for (int j = 0; j < freedoms; ++j) a[i] += mobility[i][j] * to[j];
      return a;
    }
  };

  std::vector<Body> all;
  std::vector<int> body_of;    ///< index of the body, by index of the body particle
  std::vector<Vec<D>> arm;     ///< from the centre of mass, along the axes of space [m]
  std::vector<Twist> totals;   ///< scratch: one per body
  std::uint64_t first_id = 0;  ///< of body particles in the set of walls; images follow
  Real m = 0;                  ///< mass of a fluid particle [kg/m^(3-D)]
  bool respond = false;        ///< whether the fluid moves any of them

  int count() const { return int(all.size()); }
};

/// The velocity at `arm` from the centre of mass of a body: v + omega x r [m/s].
template <int D, class Twist> FRESHET_HD Vec<D> velocity_at(const Twist& t, Vec<D> arm) {
  if constexpr (D == 3)
    return {Real(t[0] + t[4] * double(arm.z) - t[5] * double(arm.y)),
            Real(t[1] + t[5] * double(arm.x) - t[3] * double(arm.z)),
            Real(t[2] + t[3] * double(arm.y) - t[4] * double(arm.x))};
  else return {Real(t[0] - t[2] * double(arm.y)), Real(t[1] + t[2] * double(arm.x))};
}
/// The acceleration at r = `arm` from the centre of mass: a + alpha x r + omega x (omega x r)
/// [m/s^2].
template <int D, class Twist>
FRESHET_HD Vec<D> acceleration_at(const Twist& acceleration, const Twist& motion, Vec<D> arm) {
  const Twist &a = acceleration, &w = motion;
  const Vec<D, double> r = to_double(arm);
  if constexpr (D == 3) {
    const Vec<3, double> alpha{a[3], a[4], a[5]}, omega{w[3], w[4], w[5]};
    const auto at =
        Vec<3, double>{a[0], a[1], a[2]} + cross(alpha, r) + cross(omega, cross(omega, r));
    return {Real(at.x), Real(at.y), Real(at.z)};
  } else {
    return {Real(a[0] - a[2] * r.y - w[2] * w[2] * r.x),
            Real(a[1] + a[2] * r.x - w[2] * w[2] * r.y)};
  }
}
/// The force and torque about the centre of mass of a force f that acts at `arm`.
template <int D> FRESHET_HD typename RigidBodies<D>::Twist wrench_of(Vec<D> f, Vec<D> arm) {
  const Vec<D, double> F = to_double(f), r = to_double(arm);
  if constexpr (D == 3)
    return {{F.x, F.y, F.z, r.y * F.z - r.z * F.y, r.z * F.x - r.x * F.z, r.x * F.y - r.y * F.x}};
  else return {{F.x, F.y, r.x * F.y - r.y * F.x}};
}

}  // namespace FRESHET_ISA
}  // namespace freshet
