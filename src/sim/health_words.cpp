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

/// What speeds are compared with. Without sound a tenth of the nominal one.
const char* Health::reference() const {
  if (!scene_.method().incompressible()) return "sound";
  const bool is_driven = 10 * drive_speed_ > 0.99 * derived_.sound_speed;
  return is_driven ? "the fastest solid" : "the start or a fall through the domain";
}
double Health::times_reference(double speed) const {
  return speed / sound_speed() * (scene_.method().incompressible() ? 10 : 1);
}

/// What to do where no cause is known.
std::string Health::came_too_close() const {
  constexpr std::int64_t start = 10;  // so many steps belong to it
  return fmt::format(
      "particles came too close; {}, or make {} smaller",
      moment_.step <= start ? "check the start of the scene" : "check what moves or meets there",
      step_key(scene_));
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
        step_key(scene_));
  std::string why =
      fmt::format("make solver.max_iterations or {} larger, or {} smaller{}", key, step_key(scene_),
                  scene_.time.retry ? "" : ", or set time.retry = true");
  const bool stuck = error < coarse_density || iterations < scene_.solver.max_iterations;
  if (moment_.dt > step_reserve * bounds.flow)
    why = fmt::format(
        "the time step, {:.4g} s, is too long for this flow, {:.4g} s are its bound; "
        "make {} smaller",
        moment_.dt, bounds.flow, step_key(scene_));
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

std::string Health::cause(std::string words) const {
  find_cause({scene_, derived_, record_, fluid_, now_, bodies_, moment_.time, reference_speed()},
             words);
  return words;
}

}  // namespace freshet
