// SPDX-License-Identifier: MIT
#include "progress.h"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <utility>

#include "freshet/units.h"
#include "interrupts.h"
#include "print.h"

namespace freshet::cli {
namespace {

/// Text that is seen at once.
void show_text(const std::string& text) {
  put_text(text);
  flush_output();
}
/// The progress bar, with its control characters, or JSON.
void show_bytes(const std::string& bytes) {
  put(bytes);
  flush_output();
}

}  // namespace

Count::Count(bool quiet, const char* noun)
    : shown_(!quiet && isatty(STDOUT_FILENO) == 1), noun_(noun) {}

bool Count::operator()(std::size_t done, std::size_t all) const {
  if (shown_) show_bytes(fmt::format("\r{} of {} {}", done, all, noun_));
  return !stop_asked();
}

void Count::finish() const {
  if (shown_) put("\r");
}

std::string short_number(double value) {
  const char* unit = "";
  for (const char* next : {" k", " M", " G", " T"}) {
    if (std::abs(value) < 999.5) break;
    value /= 1000;
    unit = next;
  }
  return fmt::format("{:.3g}{}", value, unit);
}

std::string duration(double seconds) {
  if (!std::isfinite(seconds)) return "?";
  if (seconds < 9.95) return fmt::format("{:.2g} s", seconds);
  if (seconds < 59.5) return fmt::format("{:.0f} s", seconds);
  const double minutes = std::floor((seconds + 0.5) / 60);
  if (minutes < 60)
    return fmt::format("{:.0f} min {:.0f} s", minutes, std::floor(seconds + 0.5 - 60 * minutes));
  const double hours = std::floor((seconds + 30) / 3600);
  if (hours < 48)
    return fmt::format("{:.0f} h {:.0f} min", hours,
                       std::floor((seconds + 30 - 3600 * hours) / 60));
  return fmt::format("{:.0f} d {:.0f} h", std::floor(seconds / 86400),
                     std::floor(std::fmod(seconds, 86400) / 3600));
}

std::string solve_words(const SolveStatistics& s) {
  return fmt::format(
      "{:.3g} iterations, at most {}; error {:.3g} %, at worst {:.3g} %; {} of {} did not converge",
      s.mean_iterations(), s.most_iterations, 100 * s.last_error, 100 * s.worst_error,
      s.not_converged, s.solves);
}

Progress::Style Progress::choose(bool quiet, bool json) {
  if (quiet) return Style::quiet;
  if (json) return Style::json;
  return isatty(STDOUT_FILENO) ? Style::bar : Style::lines;
}

void Progress::start(const Simulation& sim) {
  const Scene& s = sim.scene();
  const bool alone = sim.fluid().size() == 0 && s.fluid.empty() && s.inlet.empty();
  const std::string things =
      alone ? fmt::format("{} bod{}", s.body.size(), s.body.size() == 1 ? "y" : "ies")
            : fmt::format("{} particles", sim.fluid().size());
  say(s.time.adaptive ? fmt::format("{}, {:g} s in steps of at most {:g} s", things, s.time.end,
                                    *s.time.step_max)
                      : fmt::format("{}, {} steps of {:g} s", things, s.steps(), s.time.step));
  event(json_text(
      nlohmann::ordered_json{{"event", "start"},
                             {"particles", sim.fluid().size()},
                             {"steps", s.steps()},
                             {"time_step", s.time.adaptive ? *s.time.step_max : s.time.step}}));
  begin_ = Clock::now();
  anchor_ = next_anchor_ = {0, sim.time(), double(sim.fluid().size())};
  shown_solves_ = sim.solves();
  for (SolveStatistics& solve : shown_solves_) {  // the step that is just done is this run's
    --solve.solves;
    solve.iterations -= solve.last_iterations;
  }
}

/// A bar moves ten times a second; lines come at every tenth of the run, or after ten seconds.
bool Progress::due(double done) {
  const double quiet_for = std::chrono::duration<double>(Clock::now() - shown_at_).count();
  if (style_ == Style::bar) return quiet_for > 0.1 || done >= 1;
  if (style_ == Style::json) return quiet_for > 1 || done >= 1;
  return std::floor(done * 10) > std::floor(shown_ * 10) || (quiet_for > 10 && shown_step_ >= 0);
}

namespace {
double share_done(const Simulation& sim) {
  return sim.finished() ? 1 : sim.time() / sim.scene().time.end;
}
}  // namespace

void Progress::update(const Simulation& sim, double seconds) {
  if (style_ == Style::quiet) return;
  const double done = share_done(sim);
  if (!due(done)) return;
  show(sim, seconds);
  shown_at_ = Clock::now();
  shown_ = done;
  shown_step_ = sim.steps_done();
  shown_solves_ = sim.solves();
}

/// The mean of a solve over the steps since it was last told.
double Progress::iterations_since_shown(const SolveStatistics& solve) const {
  for (const SolveStatistics& shown : shown_solves_)
    if (shown.name == solve.name && shown.solves < solve.solves)
      return double(solve.iterations - shown.iterations) / double(solve.solves - shown.solves);
  return double(solve.last_iterations);
}

/// The remaining wall time, by the rate over the last half to three quarters of this run so far.
/// Where particles come or go, by their trend as well. NaN after the first step.
double Progress::remaining(const Simulation& sim) {
  const double wall = std::chrono::duration<double>(Clock::now() - begin_).count();
  const Moment now{wall, sim.time(), double(sim.fluid().size())};
  if (now.wall > 2 * next_anchor_.wall) anchor_ = std::exchange(next_anchor_, now);
  const double gone = now.time - anchor_.time;
  const double left = sim.finished() ? 0 : sim.scene().time.end - now.time;
  const double mean = (now.particles + anchor_.particles) / 2;  // while `gone` passed
  const double trend = (now.particles - anchor_.particles) / gone * left / 2;
  const double growth = mean > 0 ? std::max(0.0, (now.particles + trend) / mean) : 1;
  return left == 0 ? 0 : (now.wall - anchor_.wall) / gone * left * growth;
}

void Progress::show(const Simulation& sim, double seconds) {
  const double done = share_done(sim);
  const double rate = double(sim.steps_done()) / std::max(seconds, 1e-9);
  const double eta = remaining(sim);
  const Statistics s = sim.statistics();
  const double particle_rate = rate * double(s.particles);
  if (style_ == Style::json) {
    nlohmann::ordered_json json{{"event", "progress"},
                                {"step", sim.steps_done()},
                                {"time", sim.time()},
                                {"steps_per_second", rate},
                                {"particle_steps_per_second", particle_rate},
                                {"eta_seconds", eta},
                                {"kinetic_energy", s.kinetic_energy},
                                {"potential_energy", s.potential_energy}};
    for (const SolveStatistics& solve : sim.solves())
      json["solves"].push_back({{"name", solve.name},
                                {"iterations", iterations_since_shown(solve)},
                                {"error", solve.last_error}});
    if (!sim.solves().empty()) json["retried"] = sim.time_steps().retried;
    event(json_text(json));
    return;
  }
  std::string facts = fmt::format(
      "{:.4g} of {:.4g} s  {} steps/s  {} particle-steps/s  ETA {}  energy {:.4g} {}", sim.time(),
      sim.scene().time.end, short_number(rate), short_number(particle_rate), duration(eta),
      s.kinetic_energy + s.potential_energy, units_in(sim.scene().dimension()).energy);
  for (const SolveStatistics& solve : sim.solves())
    facts += fmt::format("  {} {:.3g} iterations", solve.name, iterations_since_shown(solve));
  if (const auto retried = sim.time_steps().retried)
    facts += fmt::format("  {} steps halved", retried);
  if (style_ == Style::lines) return show_text(fmt::format("{:3.0f} %  {}\n", 100 * done, facts));
  const int width = 24, full = int(done * width);
  std::string bar;
  for (int k = 0; k < width; ++k) bar += k < full ? "█" : "░";
  show_bytes(fmt::format("\r{} {:3.0f} %  {}\033[K", bar, 100 * done, facts));
}

void Progress::end() {
  if (style_ == Style::bar && shown_step_ >= 0) show_bytes("\n");
}

void Progress::say(const std::string& line) const {
  if (style_ == Style::bar || style_ == Style::lines) show_text(line + "\n");
}

void Progress::event(const std::string& json) const {
  if (style_ == Style::json) show_bytes(json + "\n");
}

}  // namespace freshet::cli
