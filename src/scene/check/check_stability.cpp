// SPDX-License-Identifier: MIT
/// Runs that are bound to fail. `checks.when_wrong = "warn"` lets them begin.
#include <algorithm>
#include <cmath>

#include "scene/check/findings.h"
#include "scene/model/density_ratio.h"
#include "scene/model/setup.h"

namespace freshet {
namespace {

constexpr double hopeless_compression = 0.15;  // mean; the health monitor rejects a lasting 0.1

/// The axis of gravity; -1 if gravity is 0 or oblique.
int axis_of_gravity(const Scene& s) {
  int axis = -1;
  for (int k = 0; k < s.dimension(); ++k) {
    if (s.domain.gravity[std::size_t(k)] == 0) continue;
    if (axis >= 0) return -1;
    axis = k;
  }
  return axis;
}

/// The depth of the fluid when it has spread over the whole floor [m]; 0 if it may not stay.
double least_depth(const Scene& s, double particles) {
  const int axis = axis_of_gravity(s);
  if (axis < 0 || !s.outlet.empty() || s.periodic(axis)) return 0;
  double floor = 1;
  for (int k = 0; k < s.dimension(); ++k) {
    if (k != axis) floor *= s.domain.max[std::size_t(k)] - s.domain.min[std::size_t(k)];
    for (const int side : {2 * k, 2 * k + 1})
      if (!s.periodic(k) && s.side_method(side) == WallMethod::open) return 0;
  }
  return particles * std::pow(s.particles.spacing, s.dimension()) / floor;
}

/// The mean of rho/rho0 - 1 over the depth of a fluid that rests.
double compression_at_rest(const Scene& s, double depth) {
  const double g = std::abs(s.domain.gravity[std::size_t(axis_of_gravity(s))]);
  const double k = stiffness(s);
  if (s.method().pressure == PressureFamily::linear) return g * depth / (2 * k);
  // the mean of (1 + 7 g z/k)^(1/7) over 0 <= z <= depth
  const double most = 7 * g * depth / k;
  return (std::pow(1 + most, 8.0 / 7) - 1) / (8.0 / 7 * most) - 1;
}

void check_softness(const Scene& s, double particles, Findings& out) {
  const bool linear = s.method().pressure == PressureFamily::linear;
  const char* key = linear ? "solver.stiffness" : "solver.sound_speed";
  if (s.method().incompressible() || !out.given(key)) return;
  const double depth = least_depth(s, particles);
  if (depth == 0) return;
  const auto axis = std::size_t(axis_of_gravity(s));
  const double height = s.domain.max[axis] - s.domain.min[axis];
  const double fall2 = 2 * std::abs(s.domain.gravity[axis]) * height;  // speed of a fall, squared
  if (s.time.end < 8 * height / std::sqrt(fall2)) return;  // it may end before the fluid settles
  const double compression = compression_at_rest(s, depth);
  if (compression > hopeless_compression)
    out.error(key, fmt::format("{} is {:g}: at rest, the weight of the fluid compresses it by "
                               "{:.2g} % on average, and more than 10 % is rejected; make it at "
                               "least {:.4g}",
                               key, linear ? *s.solver.stiffness : *s.solver.sound_speed,
                               100 * compression, linear ? 100 * fall2 : 10 * std::sqrt(fall2)));
}

/// At the fluid or inlet of the lightest liquid.
void check_density_ratio(const Scene& s, Findings& out) {
  if (density_ratio(s) < density_ratio_limits(s).hopeless) return;
  out.error(key_of_lightest(s), about_density_ratio(s));
}

}  // namespace

void check_stability(const Scene& s, double particles, Findings& out) {
  if (!has_fluid(s)) return;
  if (s.is_article() || s.checks.when_wrong == WhenWrong::warn) return;
  check_softness(s, particles, out);
  check_density_ratio(s, out);
}

}  // namespace freshet
