// SPDX-License-Identifier: MIT
#include "scene/check/pressure_warnings.h"

#include <algorithm>
#include <cmath>

#include "scene/check/findings.h"
#include "scene/model/body_motion.h"
#include "scene/model/density_ratio.h"
#include "scene/model/setup.h"
#include "scene/model/still_water.h"

namespace freshet {
namespace {

constexpr double least_sound = 5;  // times the fastest speed; 10 are usual
constexpr double deep = 40;        // spacings

struct Speed {
  double value = 0;  ///< [m/s]
  std::string what;
};

double length_of(const Vector& v) {
  double sum = 0;
  for (const double x : v) sum += x * x;
  return std::sqrt(sum);
}

/// The work of gravity on a fall from the highest place of a fluid to the end of the domain [J/kg].
double work_of_fall(const Scene& s, const Scene::Fluid& f) {
  double work = 0;
  const bool known = f.shape != Shape::points && f.shape != Shape::plane && f.side == Side::inside;
  const Vector high = known ? lattice_of(s, f).last(s.particles.spacing) : s.domain.max;
  const Vector low = known ? lattice_of(s, f).from : s.domain.min;
  for (std::size_t k = 0; k < s.domain.gravity.size(); ++k) {
    const double g = s.domain.gravity[k];
    work += g < 0 ? -g * (high[k] - s.domain.min[k]) : g * (s.domain.max[k] - low[k]);
  }
  return std::max(0.0, work);
}

/// The fastest that the scene itself makes its fluid.
Speed fastest_in(const Scene& s) {
  Speed fastest;
  const auto offer = [&](double value, const std::string& what) {
    if (value > fastest.value) fastest = {value, what};
  };
  for (const Scene::Fluid& f : s.fluid) {
    const double start = length_of(f.velocity);
    offer(start, "the fluid starts at");
    offer(std::sqrt(start * start + 2 * work_of_fall(s, f)), "a fall through the domain reaches");
  }
  for (std::size_t k = 0; k < s.body.size(); ++k)
    if (s.body[k].motion == BodyMotion::moved)
      offer(fastest_point(s.body[k], s.dimension(), s.time.end), s.body_name(k) + " moves at");
  const auto names = s.wall_names();
  for (std::size_t k = 0; k < s.wall.size(); ++k)
    offer(length_of(s.wall[k].velocity), names[2 * std::size_t(s.dimension()) + k] + " moves at");
  return fastest;
}

}  // namespace

std::vector<Diagnostic> pressure_warnings(const Scene& s, const Derived& d) {
  if (!has_fluid(s)) return {};
  std::vector<Diagnostic> list;
  const auto warn = [&](const std::string& key, std::string message) {
    list.push_back({Diagnostic::Severity::warning, place_of(s, key), std::move(message)});
  };
  if (s.is_article()) return list;
  const Speed fastest = fastest_in(s);
  if (!s.method().incompressible() && d.sound_speed < least_sound * fastest.value) {
    const bool linear = s.method().pressure == PressureFamily::linear;
    const double needed = 10 * fastest.value;
    warn(linear ? "solver.stiffness" : "solver.sound_speed",
         fmt::format("the speed of sound is {:.4g} m/s, and {} {:.4g} m/s: such a flow compresses "
                     "the fluid by about {:.3g} %; make {} at least {:.4g} for 1 %",
                     d.sound_speed, fastest.what, fastest.value,
                     100 * std::min(1.0, std::pow(fastest.value / d.sound_speed, 2)),
                     linear ? "solver.stiffness" : "solver.sound_speed",
                     linear ? needed * needed : needed));
  }
  if (density_ratio(s) > density_ratio_limits(s).good)
    warn(key_of_lightest(s), about_density_ratio(s));
  const double depth = still_depth(s), churning = churning_speed(s, depth);
  if (depth > deep * s.particles.spacing && churning > 0)
    warn("solver.name",
         fmt::format(
             "still water {:.3g} spacings deep keeps moving at about {:.2g} m/s with {}; {}",
             depth / s.particles.spacing, churning, s.method().name, remedy_for_churning(s)));
  return list;
}

}  // namespace freshet
