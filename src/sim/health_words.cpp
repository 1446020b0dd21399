// SPDX-License-Identifier: MIT
/// How a run's health is told: where and when, the likeliest cause, and what to do.
#include <fmt/format.h>

#include <algorithm>

#include "core/portable.h"
#include "sim/health.h"

namespace freshet {
namespace {

/// A sum over neighbours in 32-bit numbers tells a density to about this share.
constexpr double coarse_density = sizeof(Real) == sizeof(float) ? 1e-5 : 0;

}  // namespace

std::string Health::when() const {
  return fmt::format("at step {}, {:.6g} s", moment_.step, moment_.time);
}

std::string Health::place(const Witness& particle) const {
  const auto& x = particle.x;
  return scene_.dimension() == 2 ? fmt::format("({:.4g}, {:.4g})", x[0], x[1])
                                 : fmt::format("({:.4g}, {:.4g}, {:.4g})", x[0], x[1], x[2]);
}

std::string Health::fastest(const Witness& particle) const {
  return fmt::format("the fastest, particle {} at {}, has {:.3g} m/s", particle.id, place(particle),
                     particle.value);
}

std::string Health::last_fastest() const {
  const WatchRecord::Particle& p = record_.last_fastest;
  return fmt::format("at step {} {}", record_.last_step, fastest({p.id, p.x, p.value}));
}

/// What speeds are compared with. Without sound a tenth of the nominal one: see Derived.
const char* Health::reference() const {
  return scene_.method().incompressible() ? "the start or a fall through the domain" : "sound";
}
double Health::times_reference(double speed) const {
  return speed / derived_.sound_speed * (scene_.method().incompressible() ? 10 : 1);
}

/// What to do where the pressure does not keep the density of a flow as fast as `speed` [m/s].
std::string Health::too_soft(double speed) const {
  if (scene_.method().incompressible())
    return fmt::format(
        "the pressure does not hold the fluid: the time step is too long, or the iterations too "
        "few; make {} or solver.density_tolerance smaller, or solver.max_iterations larger",
        step_key());
  const bool linear = scene_.method().pressure == PressureFamily::linear;
  const double needed = 10 * speed;
  return fmt::format(
      "the fluid is too soft: sound goes at {:.3g} m/s, and should at ten times the fastest flow, "
      "{:.3g} m/s; make {} at least {:.4g}",
      derived_.sound_speed, speed, linear ? "solver.stiffness" : "solver.sound_speed",
      linear ? needed * needed : needed);
}

std::string Health::came_too_close() const {
  return fmt::format("particles came too close; look at the start of the scene, or make {} smaller",
                     step_key());
}

/// What came of a solve: of the last, or of the worst so far if that one went well.
std::string Health::not_solved(const SolveStatistics& s, const TimeStepBounds& bounds) const {
  const bool last = s.last_error > s.tolerance;
  const double error = last ? s.last_error : s.worst_error;
  const std::int64_t iterations = last ? s.last_iterations : s.most_iterations;
  const std::string key = fmt::format("solver.{}_tolerance", s.name);
  if (s.name == "viscosity")
    return fmt::format(
        "a viscosity solve did not converge: after {} iterations {:.3g} % of the equations were "
        "left, and {} is {:.3g} %, {}{}; make solver.viscosity_max_iterations or {} larger, or {} "
        "smaller",
        iterations, 100 * error, key, 100 * s.tolerance, last ? "" : "before or ", when(), key,
        step_key());
  std::string why = fmt::format("make solver.max_iterations or {} larger, or {} smaller{}", key,
                                step_key(), scene_.time.retry ? "" : ", or set time.retry = true");
  const bool stuck = error < coarse_density || iterations < scene_.solver.max_iterations;
  if (moment_.dt > step_reserve * bounds.flow)
    why = fmt::format(
        "the time step, {:.4g} s, is too long for this flow, {:.4g} s are its bound; "
        "make {} smaller",
        moment_.dt, bounds.flow, step_key());
  else if (s.tolerance < coarse_density && stuck)
    why = fmt::format(
        "{}-bit numbers do not tell so small an error, and more iterations make it no "
        "smaller; make {} larger, {:g} say",
        8 * sizeof(Real), key, coarse_density);
  return fmt::format(
      "a {} solve did not converge: after {} iterations its error was "
      "{:.3g} %, and {} is {:.3g} %, {}{}; {}",
      s.name, iterations, 100 * error, key, 100 * s.tolerance, last ? "" : "before or ", when(),
      cause(why));
}

/// The likeliest cause by what the scene and its start tell; else the one that is given.
std::string Health::cause(const std::string& otherwise) const {
  const double longest = record_.first_step > 0 && !scene_.time.adaptive
                             ? std::min(derived_.step_bound(), record_.first_bound)
                             : derived_.step_bound();
  const auto& densest = record_.first_densest;
  if (densest.value > 1.5 * derived_.rest_density)
    return fmt::format(
        "particle {} at {} had {:.3g} times its rest density at step {}: particles start too close "
        "to each other or to a wall; put them particles.spacing apart",
        densest.id, place({densest.id, densest.x, densest.value}),
        densest.value / derived_.rest_density, record_.first_step);
  if (!scene_.time.adaptive && scene_.time.step > longest)
    return fmt::format("time.step, {:.4g} s, is over its bound, {:.4g} s; make it smaller",
                       scene_.time.step, longest);
  if (!scene_.method().incompressible() && derived_.sound_speed < 5 * reference_speed())
    return too_soft(reference_speed());
  return otherwise;
}

}  // namespace freshet
