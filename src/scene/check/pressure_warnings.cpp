// SPDX-License-Identifier: MIT
#include "scene/check/pressure_warnings.h"

#include <algorithm>
#include <cmath>

#include "scene/check/findings.h"
#include "scene/model/density_ratio.h"
#include "scene/model/fastest_flow.h"
#include "scene/model/setup.h"
#include "scene/model/still_water.h"

namespace freshet {
namespace {

constexpr double least_sound = 5;  // times the fastest speed; 10 are usual
constexpr double deep = 40;        // spacings

}  // namespace

std::vector<Diagnostic> pressure_warnings(const Scene& s, const Derived& d) {
  if (!has_fluid(s)) return {};
  std::vector<Diagnostic> list;
  const auto warn = [&](const std::string& key, std::string message) {
    list.push_back({Diagnostic::Severity::warning, place_of(s, key), std::move(message)});
  };
  if (s.is_article()) return list;
  const FastestFlow fastest = fastest_flow(s);
  if (!s.method().incompressible() && d.sound_speed < least_sound * fastest.speed) {
    const bool linear = s.method().pressure == PressureFamily::linear;
    const double needed = 10 * fastest.speed;
    warn(linear ? "solver.stiffness" : "solver.sound_speed",
         fmt::format("the speed of sound is {:.4g} m/s, and {} {:.4g} m/s: such a flow compresses "
                     "the fluid by about {:.3g} %; make {} at least {:.4g} for 1 %",
                     d.sound_speed, fastest.cause, fastest.speed,
                     100 * std::min(1.0, std::pow(fastest.speed / d.sound_speed, 2)),
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
