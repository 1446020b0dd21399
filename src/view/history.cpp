// SPDX-License-Identifier: MIT
#include "view/history.h"

#include <algorithm>

#include "freshet/units.h"

namespace freshet::view {
namespace {

/// The observables of a snapshot of a simulation, by name.
std::vector<std::pair<std::string, double>> numbers_of(const Snapshot& s) {
  std::vector<std::pair<std::string, double>> all;
  const Statistics& st = *s.statistics;
  const std::string energy = std::string(" [") + units_in(s.frame.dimension).energy + "]";
  all.emplace_back("kinetic energy" + energy, st.kinetic_energy);
  all.emplace_back("potential energy" + energy, st.potential_energy);
  all.emplace_back("speed max [m/s]", st.speed_max);
  all.emplace_back("density error mean [%]", 100 * st.density_error_mean);
  all.emplace_back("density error max [%]", 100 * st.density_error_max);
  all.emplace_back("height mean [m]", st.height_mean);
  all.emplace_back("time step [s]", s.time_step);
  all.emplace_back("particles", double(st.particles));
  for (const SolveStatistics& solve : s.solves)
    all.emplace_back(solve.name + " iterations", double(solve.last_iterations));
  for (const Flow& flow : s.flows)
    all.emplace_back(flow.name + ": particles", double(flow.particles));
  for (std::size_t k = 0; k < s.frame.bodies.size(); ++k)
    all.emplace_back(s.scene->body_name(k) + ": y [m]", s.frame.bodies[k].position[1]);
  all.insert(all.end(), s.readings.begin(), s.readings.end());
  return all;
}

}  // namespace

void History::add(const Snapshot& s) {
  if (!s.statistics || !s.scene) return;
  if (s.run != run_) {
    run_ = s.run;
    interval_ = 0;
    all_.times.clear();
    all_.series.clear();
  }
  const auto time = float(s.frame.time);
  if (!all_.times.empty() && time <= all_.times.back() + interval_) return;
  for (const auto& [name, value] : numbers_of(s)) {
    const auto at = std::find_if(all_.series.begin(), all_.series.end(),
                                 [&n = name](const Series& one) { return one.name == n; });
    Series& one = at == all_.series.end() ? all_.series.emplace_back(Series{name, {}}) : *at;
    one.values.resize(all_.times.size(), one.values.empty() ? float(value) : one.values.back());
    one.values.push_back(float(value));
  }
  all_.times.push_back(time);
  for (Series& one : all_.series) one.values.resize(all_.times.size(), one.values.back());
  if (all_.times.size() >= most) thin_out();
}

void History::thin_out() {
  const auto halve = [](std::vector<float>& values) {
    for (std::size_t k = 0; 2 * k < values.size(); ++k) values[k] = values[2 * k];
    values.resize((values.size() + 1) / 2);
  };
  interval_ = 2 * (all_.times.back() - all_.times.front()) / float(all_.times.size());
  halve(all_.times);
  for (Series& one : all_.series) halve(one.values);
}

}  // namespace freshet::view
