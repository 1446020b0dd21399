// SPDX-License-Identifier: MIT
#include "run/observables.h"
#include "core/text.h"
#include "run/table.h"

#include <fmt/format.h>

#include <algorithm>

namespace freshet {
namespace {

/// A column's name that any reader of CSV takes for one: a wall may be called as its scene likes.
std::string quoted(const std::string& name) {
  if (name.find_first_of(",\"\n\r") == std::string::npos) return name;
  std::string out = "\"";
  for (const char c : name) {
    if (c == '"') out += '"';
    out += c == '\n' || c == '\r' ? ' ' : c;  // a header is one line
  }
  return out + "\"";
}

/// The solves of a step, by their solver and in its order: a table has their columns before the
/// first of them is done.
std::vector<std::string> solve_names(const Scene& s) {
  std::vector<std::string> names(s.method().solves.begin(), s.method().solves.end());
  if (s.viscosity_method() == ViscosityMethod::weiler2018) names.push_back("viscosity");
  return names;
}

/// What has been solved under that name so far; nothing before the first step.
SolveStatistics solve_named(const std::string& name, const Simulation& s) {
  const auto& solves = s.solves();
  const auto it = std::find_if(solves.begin(), solves.end(),
                               [&](const SolveStatistics& solve) { return solve.name == name; });
  return it == solves.end() ? SolveStatistics{} : *it;
}

}  // namespace

std::string observables_header(const Scene& s) {
  const bool flat = s.dimension() == 2;
  const char *density = flat ? "kg/m^2" : "kg/m^3", *force = flat ? "N/m" : "N";
  std::string line = "step,time [s],time step [s],ruled by,least bound [s]";
  for (const std::string& name : solve_names(s))
    line += fmt::format(",{0} iterations,{0} solve error [%]", name);
  line += ",kinetic energy [J],potential energy [J]";
  for (int d = 0; d < s.dimension(); ++d)
    line += fmt::format(",momentum {} [kg m/s]", axis_letters[d]);
  line += fmt::format(
      ",density mean [{0}],density max [{0}],density error mean [%],density error max [%],"
      "speed mean [m/s],speed max [m/s],fastest particle",
      density);
  if (const auto flows = s.flow_names(); !flows.empty()) {
    const char* volume = flat ? "m^2" : "m^3";
    line += ",particles";
    for (const std::string& name : flows)
      line += "," + quoted(fmt::format("volume through {} [{}]", name, volume)) + "," +
              quoted(fmt::format("flow through {} [{}/s]", name, volume));
  }
  for (const std::string& name : s.wall_names())
    for (int d = 0; d < s.dimension(); ++d)
      line += "," + quoted(fmt::format("force on {} {} [{}]", name, axis_letters[d], force));
  return line + "\n";
}

std::string observables_line(const Simulation& s, const std::vector<Vector>& wall_forces,
                             const std::vector<Flow>& flows) {
  const Statistics t = s.statistics();
  const TimeSteps& steps = s.time_steps();
  std::string line = fmt::format("{},{:.9g},{:.9g},{},{:.9g}", s.steps_done(), s.time(), steps.last,
                                 steps.last_ruled, s.bounds().least());
  for (const std::string& name : solve_names(s.scene())) {
    const SolveStatistics solve = solve_named(name, s);
    line += fmt::format(",{},{:.9g}", solve.last_iterations, 100 * solve.last_error);
  }
  line += fmt::format(",{:.9g},{:.9g}", t.kinetic_energy, t.potential_energy);
  for (const double p : t.momentum) line += fmt::format(",{:.9g}", p);
  line += fmt::format(",{:.9g},{:.9g},{:.9g},{:.9g},{:.9g},{:.9g},{}", t.density_mean,
                      t.density_max, 100 * t.density_error_mean, 100 * t.density_error_max,
                      t.speed_mean, t.speed_max, t.fastest);
  if (!flows.empty()) line += fmt::format(",{}", t.particles);
  for (const Flow& flow : flows) line += fmt::format(",{:.9g},{:.9g}", flow.volume, flow.rate);
  for (const Vector& force : wall_forces)
    for (const double f : force) line += fmt::format(",{:.9g}", f);
  return line + "\n";
}

}  // namespace freshet
