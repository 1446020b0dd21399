// SPDX-License-Identifier: MIT
#include "sim/causes.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "bodies/bodies.h"
#include "scene/model/density_ratio.h"
#include "sim/room.h"

namespace freshet {
namespace {

using Found = std::optional<std::string>;

std::string place_in(const Scene& s, const std::array<double, 3>& x) {
  return s.dimension() == 2 ? fmt::format("({:.4g}, {:.4g})", x[0], x[1])
                            : fmt::format("({:.4g}, {:.4g}, {:.4g})", x[0], x[1], x[2]);
}

Found starts_clamped(const Evidence& e) {
  if (e.derived.outside == 0) return {};
  return fmt::format(
      "{} of {:.0f} particles started outside the domain, and fluid.outside = \"clamp\" put them "
      "onto its walls, several in one place; put the fluid inside the domain, or the walls around "
      "the fluid",
      e.derived.outside, e.derived.particles);
}

Found starts_too_dense(const Evidence& e) {
  const WatchRecord::Particle& densest = e.record.first_densest;
  const double times = densest.value / e.derived.rest_density;
  if (!(times > 1.5)) return {};
  return fmt::format(
      "particle {} at {} had {:.3g} times its rest density at step {}: particles start too close "
      "to each other or to a wall; put them particles.spacing apart",
      densest.id, place_in(e.scene, densest.x), times, e.record.first_step);
}

Found fixed_step_too_long(const Evidence& e) {
  const double bound = e.record.first_step > 0
                           ? std::min(e.derived.step_bound(), e.record.first_bound)
                           : e.derived.step_bound();
  if (e.scene.time.adaptive || !(e.scene.time.step > bound)) return {};
  return fmt::format("time.step, {:.4g} s, is over its bound, {:.4g} s; make it smaller",
                     e.scene.time.step, bound);
}

Found sound_too_slow(const Evidence& e) {
  if (e.scene.method().incompressible() || e.derived.sound_speed >= 5 * e.reference_speed)
    return {};
  return too_soft(e.scene, e.derived, e.reference_speed);
}

Found body_closes(const Evidence& e) {
  const auto pinch = find_pinch(e.scene, e.bodies, e.fluid);
  if (!pinch) return {};
  return fmt::format(
      "{} closes on {} at {:.3g} m/s and traps fluid: particle {} at {} has a gap of {:.3g} m, "
      "less "
      "than particles.spacing, {:g} m; end the motion of {} two spacings before {}, or leave the "
      "fluid a way out",
      pinch->body, pinch->solid, pinch->speed, pinch->id, place_in(e.scene, pinch->x), pinch->gap,
      e.scene.particles.spacing, pinch->body, pinch->solid);
}

/// A volume that is shut, and that the fluid more than fills. Cells count its room to a few
/// percent.
Found volume_is_full(const Evidence& e) {
  const auto volume = fullest_closed_volume(e.scene, e.bodies, e.fluid, e.time);
  if (!volume) return {};
  const double share = volume->particles / volume->room;
  const std::string full =
      fmt::format("a closed volume has room for {:.0f} particles and holds {:.0f}", volume->room,
                  volume->particles);
  if (share > 0.97 && !volume->inlet.empty())
    return fmt::format(
        "{}, and {} adds more; stop it earlier (inlet.stop), or add an outlet or an "
        "open side",
        full, volume->inlet);
  if (share > 0.97 && !volume->body.empty())
    return fmt::format(
        "{} moves into a closed volume at {:.3g} m/s and leaves its fluid no room: "
        "{}; end the motion earlier, or leave the fluid a way out",
        volume->body, volume->speed, full);
  if (share > 1.05)
    return fmt::format("{}: the fluid has no room; make the fluid smaller, or the volume larger",
                       full);
  return {};
}

Found inlet_is_under_water(const Evidence& e) {
  const auto inlet = most_crowded_inlet(e.scene, e.fluid, e.time);
  if (!inlet || inlet->crowding() < 1.2) return {};
  return fmt::format(
      "liquid presses on the zone behind the opening of {}: {:.0f} particles are in it or beside "
      "it, "
      "and it has room for {:.0f}; put walls around the zone, or move the inlet above the liquid",
      inlet->name, inlet->particles, inlet->room);
}

Found densities_too_different(const Evidence& e) {
  if (!(density_ratio(e.scene) > density_ratio_limits(e.scene).good)) return {};
  return about_density_ratio(e.scene);
}

/// Only speeds that no other cause explains: the force of a formula has no reference speed.
Found force_too_strong(const Evidence& e) {
  const double speed =
      std::isfinite(e.look.fastest.value) ? e.look.fastest.value : e.record.last_fastest.value;
  if (e.scene.domain.body_force.empty() || e.scene.method().incompressible() ||
      e.derived.sound_speed >= 5 * speed)
    return {};
  return "domain.body_force drives the fluid; " + too_soft(e.scene, e.derived, speed);
}

}  // namespace

const std::vector<Cause>& causes() {
  static const std::vector<Cause> all{
      {"start outside", starts_clamped},
      {"start too dense", starts_too_dense},
      {"fixed step too long", fixed_step_too_long},
      {"sound too slow", sound_too_slow},
      {"body closes on a solid", body_closes},
      {"closed volume is full", volume_is_full},
      {"inlet is under water", inlet_is_under_water},
      {"densities too different", densities_too_different},
      {"body force too strong", force_too_strong},
  };
  return all;
}

const Cause* find_cause(const Evidence& evidence, std::string& words) {
  for (const Cause& cause : causes())
    if (auto found = cause.find(evidence)) {
      words = *std::move(found);
      return &cause;
    }
  return nullptr;
}

std::string too_soft(const Scene& s, const Derived& d, double speed) {
  if (s.method().incompressible())
    return fmt::format(
        "the pressure does not hold the fluid: the time step is too long, or the iterations too "
        "few; make {} or solver.density_tolerance smaller, or solver.max_iterations larger",
        step_key(s));
  const bool linear = s.method().pressure == PressureFamily::linear;
  const double needed = 10 * speed;
  return fmt::format(
      "the fluid is too soft: sound goes at {:.3g} m/s, and should at ten times the fastest flow, "
      "{:.3g} m/s; make {} at least {:.4g}",
      d.sound_speed, speed, linear ? "solver.stiffness" : "solver.sound_speed",
      linear ? needed * needed : needed);
}

const char* step_key(const Scene& s) { return s.time.adaptive ? "time.step_max" : "time.step"; }

}  // namespace freshet
