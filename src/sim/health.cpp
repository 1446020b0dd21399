// SPDX-License-Identifier: MIT
#include "sim/health.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "scene/model/body_motion.h"
#include "scene/model/openings.h"
#include "scene/model/setup.h"
#include "scene/model/still_water.h"

namespace freshet {
namespace {

constexpr double never = std::numeric_limits<double>::infinity();

double norm_of(const Vector& a) {
  double sum = 0;
  for (const double x : a) sum += x * x;
  return std::sqrt(sum);
}

/// The speed of a fall through the whole domain.
double fall_speed(const Scene& s) {
  double work = 0;
  for (std::size_t k = 0; k < s.domain.gravity.size(); ++k)
    work += std::abs(s.domain.gravity[k]) * (s.domain.max[k] - s.domain.min[k]);
  return std::sqrt(2 * work);
}

/// The potential energy of a particle where it is least in the domain [J/kg].
double least_potential(const Scene& s) {
  double least = 0;
  for (std::size_t k = 0; k < s.domain.gravity.size(); ++k)
    least -= std::max(s.domain.gravity[k] * s.domain.min[k], s.domain.gravity[k] * s.domain.max[k]);
  return least;
}

/// The fastest point of all moved bodies and sliding walls [m/s].
double fastest_solid(const Scene& s) {
  double fastest = 0;
  for (const Scene::Wall& wall : s.wall) fastest = std::max(fastest, norm_of(wall.velocity));
  for (const Scene::Body& body : s.body)
    if (body.motion == BodyMotion::moved)
      fastest = std::max(fastest, fastest_point(body, s.dimension(), s.time.end));
  return fastest;
}

/// Gravity that does work without end: along an axis that repeats.
bool falls_for_ever(const Scene& s) {
  for (int k = 0; k < s.dimension(); ++k)
    if (s.periodic(k) && s.domain.gravity[std::size_t(k)] != 0) return true;
  return false;
}

}  // namespace

/// What is watched: doubtful from a first bound on, fatal from a second.
struct Health::Rule {
  const char* kind;
  double doubtful, fatal;
  bool lasting;  // over half of the steps a doubt is fatal as well
  bool ends;     // beyond the fatal bound the run ends
};

Health::Health(const Scene& scene, const Derived& derived, const ParticleView& start,
               const Bodies* bodies)
    : scene_(scene),
      derived_(derived),
      bodies_(bodies),
      look_at_(look_at(scene, derived)),
      drive_speed_(fastest_solid(scene)),
      still_depth_(still_depth(scene)) {
  const Look look = look_at_(start);
  start_energy_ = look.kinetic + look.potential;
  start_available_ = std::max(0.0, start_energy_ - least_potential(scene));
  if (scene.has_flows()) expect_flows(start);
  for (const Scene::Fluid& fluid : scene.fluid)
    start_speed_ = std::max({start_speed_, norm_of(fluid.velocity), look.fastest.value});
}

/// Particles come and go, so that the mean energy may rise to that of the richest.
void Health::expect_flows(const ParticleView& start) {
  const auto d = std::size_t(start.dimension);
  const auto energy = [&](double speed2, auto height_along) {
    double e = speed2 / 2;
    for (std::size_t k = 0; k < d; ++k) e -= scene_.domain.gravity[k] * height_along(k);
    return e;
  };
  start_energy_ = least_potential(scene_);
  for (std::size_t i = 0; i < start.size(); ++i) {
    double speed2 = 0;
    for (std::size_t k = 0; k < d; ++k) speed2 += square(double(start.v[d * i + k]));
    start_energy_ =
        std::max(start_energy_, energy(speed2, [&](auto k) { return start.position(i, k); }));
  }
  for (const Scene::Inlet& in : scene_.inlet) {
    const InletPlan plan = inlet_plan(scene_, in);
    start_speed_ = std::max(start_speed_, plan.speed);
    for (std::size_t p = 0; p < plan.particles(); ++p)
      start_energy_ =
          std::max(start_energy_,
                   energy(square(plan.speed), [&](auto k) { return plan.places[p * d + k]; }));
  }
  start_available_ = std::max(0.0, start_energy_ - least_potential(scene_));
}

void Health::look(const Moment& now, const ParticleView& fluid,
                  const std::vector<SolveStatistics>& solves,
                  const std::function<TimeStepBounds()>& bounds) {
  see(now, fluid);
  if (fluid.size() == 0 && !has_fluid(scene_)) return;  // bodies alone
  const bool first = record_.first_step == 0;
  if (first && scene_.solver.scheme != Scheme::article) {
    record_.first_step = now.step;
    record_.first_compression = now_.compression;
    record_.first_densest = {now_.densest.id, now_.densest.x, now_.densest.value};
    if (!scene_.time.adaptive) record_.first_bound = bounds().least();
  }
  if (now_.lost) fail_for_lost();
  if (scene_.solver.scheme == Scheme::article) return;  // its densities are none: docs/article.md
  record_.steps_watched += steps_since_last();
  if (!scene_.time.adaptive) judge_step(bounds());
  judge_walls(fluid.size());
  judge_density();
  // A body force, a surface and the wind make any speed and energy.
  const bool driven = intervened_ || !scene_.domain.body_force.empty() ||
                      scene_.air.drag != Drag::none ||
                      scene_.solver.surface_tension_method != SurfaceTensionMethod::none;
  const bool falls = std::any_of(scene_.body.begin(), scene_.body.end(), [](const auto& body) {
    return body.motion == BodyMotion::free;  // and gives the fluid its energy
  });
  if (!driven) judge_speed();
  if (!driven && !falls) judge_energy();
  if (!intervened_) judge_stillness();
  judge_solves(solves, bounds);
  for (std::size_t k = 0; k < record_.tracks.size(); ++k) {
    const WatchRecord::Track& t = record_.tracks[k];
    record_.warnings[k].cannot_be_right =
        t.fatal || (t.lasting && 2 * t.steps > record_.steps_watched);
  }
  record_.last_step = now.step;
  record_.last_fastest = {now_.fastest.id, now_.fastest.x, now_.fastest.value};
}

void Health::see(const Moment& now, const ParticleView& fluid) {
  moment_ = now;
  fluid_ = fluid;
  now_ = look_at_(fluid);
}

void Health::look_for_lost(const Moment& now, const ParticleView& fluid) {
  see(now, fluid);
  if (now_.lost) fail_for_lost();
}

std::int64_t Health::steps_since_last() const { return moment_.step - record_.last_step; }

template <class Message>
void Health::judge(const Rule& rule, double value, std::int64_t steps, Message message) {
  if (!(value > rule.doubtful)) return;
  const bool fatal = value > rule.fatal;
  if (fatal && rule.ends && scene_.checks.when_wrong == WhenWrong::stop)
    throw Error(Error::Kind::run, "", "the run cannot be right: " + message());
  std::size_t k = 0;
  while (k < record_.warnings.size() && record_.warnings[k].kind != rule.kind) ++k;
  if (k == record_.warnings.size()) {
    record_.tracks.push_back({rule.lasting, false, 0});
    Warning w{rule.kind, message()};
    w.first_step = moment_.step;
    w.first_time = moment_.time;
    w.bound = rule.doubtful;
    record_.warnings.push_back(std::move(w));
  }
  Warning& w = record_.warnings[k];
  w.last_step = moment_.step;
  ++w.looks;
  if (value > w.worst) {
    w.worst = value;
    w.worst_step = moment_.step;
  }
  record_.tracks[k].fatal |= fatal;
  record_.tracks[k].steps += steps;
}

void Health::judge_step(const TimeStepBounds& bounds) {
  static constexpr Rule rule{"time step", step_reserve, never, false, false};
  const double over = moment_.dt / bounds.least();
  judge(rule, over, [&] {
    return fmt::format(
        "time.step, {:.4g} s, is {:.3g} times the longest that is safe now, {:.4g} s (by the bound "
        "of {}), {}; {}; the run may blow up; make time.step smaller",
        moment_.dt, over, bounds.least(), bounds.ruling(), when(), fastest(now_.fastest));
  });
}

void Health::judge_walls(std::size_t particles) {
  static constexpr Rule rule{"walls", 0, 0.01, false, false};
  judge(rule, double(now_.left) / double(particles), [&] {
    return fmt::format(
        "{} of {} particles went through walls that should hold them, the first of them particle "
        "{} at {}, {}; {}",
        now_.left, particles, now_.first_left.id, place(now_.first_left), when(),
        cause("the walls are too weak for this flow; choose another method for them, or make "
              "particles.spacing smaller"));
  });
}

void Health::judge_density() {
  static constexpr Rule rule{"density", 0.1, 1, true, true};
  judge(rule, now_.density_error, [&] {
    return fmt::format(
        "the fluid is {:.3g} % denser than at rest on average, particle {} at {} {:.3g} times as "
        "dense, {}; {}",
        100 * now_.density_error, now_.densest.id, place(now_.densest),
        now_.densest.value / derived_.rest_density, when(),
        cause(too_soft(scene_, derived_, std::max(reference_speed(), now_.fastest.value))));
  });
}

void Health::judge_speed() {
  static constexpr Rule all{"speed", 0.3, 1, true, true};
  static constexpr Rule one{"fastest particle", 1, never, true, false};
  const double sound = sound_speed();
  if (!(sound > 0)) return;  // nothing moves the fluid, so that there is no measure
  judge(all, now_.agitation / sound, [&] {
    return fmt::format(
        "the particles move at {:.3g} m/s (root mean square about their mean velocity), {:.3g} "
        "times the speed of {}, {}; {}; {}",
        now_.agitation, times_reference(now_.agitation), reference(), when(), fastest(now_.fastest),
        cause(too_soft(scene_, derived_, now_.fastest.value)));
  });
  judge(one, now_.fastest.value / sound, [&] {
    return fmt::format("a particle is {:.3g} times as fast as {}, {}; {}; {}",
                       times_reference(now_.fastest.value), reference(), when(),
                       fastest(now_.fastest), cause(came_too_close()));
  });
}

void Health::judge_energy() {
  static constexpr Rule keeps{"energy", 0.5, 10, true, true};
  static constexpr Rule boils{"energy", 0.5, 10, false, true};
  if (falls_for_ever(scene_) || !(sound_speed() > 0)) return;
  const bool linear = scene_.method().pressure == PressureFamily::linear;
  const double made = now_.kinetic + now_.potential - start_energy_;
  const double share = made / energy_available();
  judge(linear ? boils : keeps, share, [&] {
    return fmt::format(
        "{:.4g} J/kg of energy came from nowhere, {:.3g} times what could become motion, {}; {}; "
        "{}",
        made, share, when(), fastest(now_.fastest),
        cause(linear ? "the scheme of mueller2003 does not keep energy where little viscosity "
                       "takes it up; make fluid.viscosity larger, or choose wcsph or delta_sph as "
                       "solver.name"
                     : came_too_close()));
  });
}

/// Water that nothing can move has settled after the time of a few falls through its depth.
void Health::judge_stillness() {
  static constexpr Rule rule{"still water", 0.12, never, false, false};
  if (still_depth_ == 0 || scene_.method().pressure == PressureFamily::linear) return;
  const double g = std::abs(scene_.domain.gravity[1]);
  if (moment_.time < 5 * std::sqrt(2 * still_depth_ / g)) return;
  judge(rule, now_.agitation / std::sqrt(g * scene_.particles.spacing), [&] {
    return fmt::format(
        "water that should be still moves at {:.3g} m/s (root mean square), {}; {}; "
        "{}",
        now_.agitation, when(), fastest(now_.fastest), remedy_for_churning(scene_));
  });
}

void Health::look_at_whitewater(const WhitewaterView& whitewater) {
  static constexpr Rule rule{"whitewater", 0, never, false, false};
  judge(rule, double(whitewater.refused), [&] {
    return fmt::format(
        "there is room for {} whitewater particles, and no more are born, {}; make "
        "whitewater.max_particles larger, or whitewater.trapped_air and whitewater.wave_crest "
        "smaller",
        whitewater.size(), when());
  });
}

/// The doubt counts the steps in which a solve ended beyond its tolerance.
void Health::judge_solves(const std::vector<SolveStatistics>& solves,
                          const std::function<TimeStepBounds()>& bounds) {
  static constexpr Rule pressure{"pressure solve", 1, never, true, false};
  static constexpr Rule viscosity{"viscosity solve", 1, never, true, false};
  record_.not_converged.resize(solves.size());
  std::int64_t most = 0;
  const SolveStatistics* worst = nullptr;
  for (std::size_t k = 0; k < solves.size(); ++k) {
    const std::int64_t all = solves[k].not_converged;
    const std::int64_t failed = all - std::exchange(record_.not_converged[k], all);
    if (failed <= most) continue;
    most = failed;
    worst = &solves[k];
  }
  if (worst)
    judge(worst->name == "viscosity" ? viscosity : pressure, worst->worst_error / worst->tolerance,
          std::min(most, steps_since_last()), [&] { return not_solved(*worst, bounds()); });
}

/// What the start had, that a fall to the bottom and a relaxing of the first densities give, and
/// sound waves that change the density by 1 %. What a moved solid may give as well: it lifts all
/// fluid to the top of the domain and throws it at four times its own speed [J/kg].
double Health::energy_available() const {
  const double c2 = square(sound_speed());
  const double driven =
      drive_speed_ > 0 ? square(fall_speed(scene_)) / 2 + square(4 * drive_speed_) / 2 : 0;
  return start_available_ + 2 * driven + c2 / 2 * (record_.first_compression + 0.01 * 0.01);
}

/// Without sound the nominal one: ten times the fastest that moves the fluid [m/s].
double Health::sound_speed() const {
  const double nominal = scene_.method().incompressible() ? 10 * drive_speed_ : 0;
  return std::max(derived_.sound_speed, nominal);
}

void Health::fail_for_lost() const {
  const Witness& lost = *now_.lost;
  const std::string before = record_.last_step == 0 ? "" : fmt::format(" ({})", last_fastest());
  throw Error(Error::Kind::run, "",
              fmt::format("particle {} is {}, at {}, {}{}; {}", lost.id,
                          lost.value > 0 ? "no number any more" : "lost", place(lost), when(),
                          before, cause(came_too_close())));
}

void Health::fail_for_step(const Moment& now, const ParticleView& fluid,
                           const TimeStepBounds& bounds) {
  see(now, fluid);
  const bool weakly = scene_.method().weakly_compressible();
  const bool from_the_start = !(derived_.step_bound() > least_step());
  const std::string bound = bounds.ruling();
  std::string why = "the run has blown up; " + cause(came_too_close());
  if (from_the_start)
    why = fmt::format("{} asks for it; make it smaller",
                      bound == "force"  ? "domain.gravity"
                      : bound == "flow" ? "fluid.velocity"
                      : bound == "viscosity"
                          ? weakly && scene_.viscosity_method() == ViscosityMethod::artificial
                                ? "solver.artificial_viscosity"
                                : "fluid.viscosity"
                      : bound == "surface tension" ? "fluid.surface_tension"
                      : weakly                     ? "solver.sound_speed"
                                                   : "solver.stiffness");
  else if (record_.last_step > 0) why = fmt::format("{}; {}", last_fastest(), why);
  throw Error(Error::Kind::run, "",
              fmt::format("the time step fell to {:.3g} s, by the bound of {}, at step {}, {:.6g} "
                          "s; {}",
                          now.dt, bound, now.step, now.time, why));
}

/// The fastest that the scene itself makes its fluid: it starts so, falls through the domain, or
/// is pushed by a solid.
double Health::reference_speed() const {
  return std::max({start_speed_, drive_speed_, fall_speed(scene_)});
}

}  // namespace freshet
