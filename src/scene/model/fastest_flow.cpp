// SPDX-License-Identifier: MIT
#include "scene/model/fastest_flow.h"

#include <algorithm>
#include <cmath>

#include "scene/model/body_motion.h"
#include "scene/model/openings.h"
#include "scene/model/setup.h"

namespace freshet {
namespace {

double length_of(const Vector& v) {
  double sum = 0;
  for (const double x : v) sum += x * x;
  return std::sqrt(sum);
}

/// The work of gravity on a fall from the highest place of a box to the end of the domain [J/kg].
/// The box is larger by `margin` [m] on every side.
double work_of_fall(const Scene& s, const Vector& low, const Vector& high, double margin) {
  double work = 0;
  for (std::size_t k = 0; k < s.domain.gravity.size(); ++k) {
    const double g = s.domain.gravity[k];
    work += std::abs(g) * (margin + (g < 0 ? high[k] - s.domain.min[k] : s.domain.max[k] - low[k]));
  }
  return std::max(0.0, work);
}

double work_of_fall(const Scene& s) { return work_of_fall(s, s.domain.min, s.domain.max, 0); }

double work_of_fall(const Scene& s, const Scene::Fluid& f) {
  const bool known = f.shape != Shape::points && f.shape != Shape::plane && f.side == Side::inside;
  if (!known) return work_of_fall(s);
  const Lattice lattice = lattice_of(s, f);
  const double spacing = s.particles.spacing;
  return std::min(work_of_fall(s),
                  work_of_fall(s, lattice.from, lattice.last(spacing), spacing / 2));
}

double work_of_fall(const Scene& s, const Scene::Inlet& in) {
  const bool known = in.radius || in.width;
  if (!known) return work_of_fall(s);
  const double reach =
      in.radius ? *in.radius : std::hypot(in.width.value_or(0), in.height.value_or(0)) / 2;
  return std::min(work_of_fall(s), work_of_fall(s, in.center, in.center, reach));
}

}  // namespace

double fall_through_domain(const Scene& s) { return std::sqrt(2 * work_of_fall(s)); }

FastestFlow fastest_flow(const Scene& s) {
  FastestFlow fastest;
  const auto offer = [&](double speed, const std::string& cause) {
    if (speed > fastest.speed) fastest = {speed, cause};
  };
  const auto fall = [&](double start, double work) {
    offer(std::sqrt(start * start + 2 * work), "a fall through the domain reaches");
  };
  for (const Scene::Fluid& f : s.fluid) {
    const double start = length_of(f.velocity);
    offer(start, "the fluid starts at");
    fall(start, work_of_fall(s, f));
  }
  if (s.fluid.empty() && s.inlet.empty()) fall(0, work_of_fall(s));  // a program may add fluid
  for (const Scene::Inlet& in : s.inlet) {
    const double start = inlet_plan(s, in).speed;
    offer(start, "an inlet emits at");
    fall(start, work_of_fall(s, in));
  }
  for (std::size_t k = 0; k < s.body.size(); ++k) {
    const Scene::Body& body = s.body[k];
    if (body.motion == BodyMotion::moved)
      offer(fastest_point(body, s.dimension(), s.time.end), s.body_name(k) + " moves at");
    if (body.motion == BodyMotion::free) fall(length_of(body.velocity), work_of_fall(s));
  }
  const auto names = s.wall_names();
  for (std::size_t k = 0; k < s.wall.size(); ++k)
    offer(length_of(s.wall[k].velocity), names[2 * std::size_t(s.dimension()) + k] + " moves at");
  return fastest;
}

}  // namespace freshet
