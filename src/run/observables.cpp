// SPDX-License-Identifier: MIT
#include "run/observables.h"

#include <fmt/format.h>

#include <algorithm>

#include "core/text.h"
#include "freshet/units.h"
#include "run/interval.h"
#include "run/table.h"

namespace freshet {
namespace {

/// The names of the solves of a step, in the order of the solver.
std::vector<std::string> solve_names(const Scene& s) {
  std::vector<std::string> names(s.method().solves.begin(), s.method().solves.end());
  if (s.viscosity_method() == ViscosityMethod::weiler2018) names.push_back("viscosity");
  return names;
}

/// The statistics of the solves of a name; zeros before the first step.
SolveStatistics solve_named(const std::string& name, const Simulation& s) {
  const auto& solves = s.solves();
  const auto it = std::find_if(solves.begin(), solves.end(),
                               [&](const SolveStatistics& solve) { return solve.name == name; });
  return it == solves.end() ? SolveStatistics{} : *it;
}

/// The walls and bodies whose forces have statistics.
std::vector<std::string> loaded_names(const Scene& s) {
  std::vector<std::string> names = s.wall_names();
  for (std::size_t k = 0; k < s.body.size(); ++k) names.push_back(s.body_name(k));
  return names;
}

}  // namespace

std::string flow_columns(const Scene& s, const std::string& name) {
  const Units units = units_in(s.dimension());
  return "," + csv_cell(fmt::format("volume through {} [{}]", name, units.volume)) + "," +
         csv_cell(fmt::format("flow through {} [{}]", name, units.flow_rate));
}

std::string force_columns(const Scene& s, const std::string& name) {
  const Units units = units_in(s.dimension());
  std::string columns;
  for (int d = 0; d < s.dimension(); ++d)
    columns +=
        "," + csv_cell(fmt::format("force on {} {} [{}]", name, axis_letters[d], units.force));
  return columns;
}

std::string observables_header(const Scene& s) {
  const Units units = units_in(s.dimension());
  std::string line = "step,time [s],time step [s],ruled by,least bound [s]";
  for (const std::string& name : solve_names(s))
    line += fmt::format(",{0} iterations,{0} solve error [%]", name);
  line += fmt::format(",kinetic energy [{0}],potential energy [{0}]", units.energy);
  for (int d = 0; d < s.dimension(); ++d)
    line += fmt::format(",momentum {} [{}]", axis_letters[d], units.momentum);
  for (int d = s.dimension() == 2 ? 2 : 0; d < 3; ++d)
    line += fmt::format(",angular momentum {} [{}]", axis_letters[d], units.angular_momentum);
  line += fmt::format(
      ",density mean [{0}],density max [{0}],density error mean [%],density error max [%],"
      "speed mean [m/s],speed max [m/s],fastest particle",
      units.density);
  if (const auto flows = s.flow_names(); !flows.empty()) {
    line += ",particles";
    for (const std::string& name : flows) line += flow_columns(s, name);
  }
  for (const std::string& name : s.wall_names()) line += force_columns(s, name);
  if (s.output.statistics)
    for (const std::string& name : loaded_names(s))
      for (int d = 0; d < s.dimension(); ++d)
        line += interval_columns(fmt::format("force on {} {}", name, axis_letters[d]), units.force);
  return line + "\n";
}

std::vector<double> loads(const Simulation& s, const std::vector<Vector>& wall_forces) {
  std::vector<double> all;
  for (const Vector& force : wall_forces) all.insert(all.end(), force.begin(), force.end());
  for (const BodyState& body : s.bodies())
    all.insert(all.end(), body.force.begin(), body.force.begin() + s.scene().dimension());
  return all;
}

std::string observables_line(const Simulation& s, const std::vector<Vector>& wall_forces,
                             const std::vector<Flow>& flows, const IntervalRecord& interval) {
  const Statistics t = s.statistics();
  const TimeSteps& steps = s.time_steps();
  std::string line = fmt::format("{},{:.9g},{:.9g},{},{:.9g}", s.steps_done(), s.time(), steps.last,
                                 steps.last_ruled, s.bounds().least());
  for (const std::string& name : solve_names(s.scene())) {
    const SolveStatistics solve = solve_named(name, s);
    line += fmt::format(",{},{:.9g}", solve.last_iterations, 100 * solve.last_error);
  }
  line += fmt::format(",{:.9g},{:.9g}", t.kinetic_energy, t.potential_energy);
  for (const auto* momentum : {&t.momentum, &t.angular_momentum})
    for (const double p : *momentum) line += fmt::format(",{:.9g}", p);
  line += fmt::format(",{:.9g},{:.9g},{:.9g},{:.9g},{:.9g},{:.9g},{}", t.density_mean,
                      t.density_max, 100 * t.density_error_mean, 100 * t.density_error_max,
                      t.speed_mean, t.speed_max, t.fastest);
  if (!flows.empty()) line += fmt::format(",{}", t.particles);
  for (const Flow& flow : flows) line += fmt::format(",{:.9g},{:.9g}", flow.volume, flow.rate);
  for (const Vector& force : wall_forces)
    for (const double f : force) line += fmt::format(",{:.9g}", f);
  if (s.scene().output.statistics)
    line += interval_cells(interval, 0,
                           loaded_names(s.scene()).size() * std::size_t(s.scene().dimension()));
  return line + "\n";
}

}  // namespace freshet
