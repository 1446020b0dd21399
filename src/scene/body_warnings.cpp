// SPDX-License-Identifier: MIT
#include "scene/body_warnings.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "scene/body_motion.h"
#include "scene/body_shape.h"
#include "scene/findings.h"

namespace freshet {
namespace {

constexpr double lightest = 0.1;  // of the fluid's density: tried so far

/// The greatest speed of a place of a moved body [m/s], looked for at many moments.
double fastest(const Scene& s, const Scene::Body& b) {
  const PrescribedMotion motion(b, s.dimension());
  const BodyShape shape = body_shape(b);
  double arm = shape.reach;
  if (!b.pivot.empty()) {
    double off2 = 0;
    const double center[] = {shape.center.x, shape.center.y, shape.center.z};
    for (std::size_t d = 0; d < b.pivot.size(); ++d) off2 += std::pow(b.pivot[d] - center[d], 2);
    arm += std::sqrt(off2);
  }
  double most = 0;
  for (int k = 0; k <= 1000; ++k) {
    const auto rate = motion.at(s.time.end * k / 1000).rate;
    most = std::max(most, std::hypot(rate[0], rate[1], rate[2]) + arm * std::abs(rate[3]));
  }
  return most;
}

}  // namespace

std::vector<Diagnostic> body_warnings(const Scene& s, const Derived& d) {
  std::vector<Diagnostic> list;
  const auto warn = [&](const std::string& key, std::string message) {
    list.push_back({Diagnostic::Severity::warning, place_of(s, key), std::move(message)});
  };
  bool free = false;
  for (std::size_t k = 0; k < s.body.size(); ++k) {
    const Scene::Body& b = s.body[k];
    const std::string at = fmt::format("body[{}].", k), name = s.body_name(k);
    free |= b.motion == BodyMotion::free;
    if (b.motion == BodyMotion::free) {
      const double density = b.density.value_or(b.mass.value_or(0) / body_shape(b).volume);
      if (density < lightest * d.rest_density)
        warn(at + (b.density ? "density" : "mass"),
             fmt::format("{} has {:.2g} times the density of the fluid: what it pushes aside "
                         "weighs so much more that its motion may shake; {:g} times or more are "
                         "calm",
                         name, density / d.rest_density, lightest));
    }
    if (b.motion != BodyMotion::moved || s.time.adaptive) continue;
    const double bound = 0.4 * d.support_radius / 2 / fastest(s, b);
    if (s.time.step > bound)
      warn("time.step", fmt::format("the time step {:.4g} s is over {:.4g} s, in which {} moves "
                                    "0.4 h; fluid may pass through it",
                                    s.time.step, bound, name));
  }
  for (std::size_t k = 0; k < s.wall.size() && free; ++k) {
    const Scene::Wall& w = s.wall[k];
    const bool round = w.shape == Shape::sphere || w.shape == Shape::cylinder;
    if (w.shape == Shape::points || (round && w.side == Side::inside))
      warn(fmt::format("wall[{}].shape", k),
           fmt::format("free bodies do not collide with {}, {}: it holds the fluid only",
                       s.wall_names()[2 * std::size_t(s.dimension()) + k],
                       w.shape == Shape::points ? "which is of points" : "whose inside is round"));
  }
  return list;
}

}  // namespace freshet
