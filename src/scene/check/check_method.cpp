// SPDX-License-Identifier: MIT
/// The solver, the time and the output.
#include <algorithm>
#include <cmath>
#include <set>

#include <fmt/ranges.h>

#include "scene/check/findings.h"
#include "scene/keys/keys.h"
#include "scene/model/expressions.h"

namespace freshet {
namespace {

constexpr double most_steps = 1e9, most_frames = 100000;

bool is_weightless(const Scene& s) {
  return std::all_of(s.domain.gravity.begin(), s.domain.gravity.end(),
                     [](double g) { return g == 0; });
}

void check_backend(const Scene& s, Findings& out) {
  if (s.solver.backend == BackendName::reference) return;
  if (s.solver.neighbor_order == NeighborOrder::id)
    out.error("solver.neighbor_order",
              "solver.neighbor_order = \"id\" needs the reference backend; set "
              "solver.backend = \"reference\", or choose \"cell\"");
  if (s.solver.search == Search::all_pairs)
    out.error("solver.search",
              "solver.search = \"all_pairs\" needs the reference backend; set "
              "solver.backend = \"reference\", or choose \"grid\"");
}

/// The solvers that read a key: "only dfsph reads it; remove it, or choose solver.name = "dfsph"".
std::string readers_of(std::string_view key) {
  std::vector<std::string> names;
  for (const SolverMethod* m : solver_methods())
    if (m->reads(key)) names.push_back(m->name);
  if (names.size() == 1)
    return fmt::format("only {0} reads it; remove it, or choose solver.name = \"{0}\"", names[0]);
  const std::string last = names.back();
  names.pop_back();
  return fmt::format("only {} and {} read it; remove it, or choose one of them as solver.name",
                     fmt::join(names, ", "), last);
}

/// Reports keys that only other solvers read.
void check_keys_of_solvers(const Scene& s, Findings& out) {
  const SolverMethod& own = s.method();
  const auto instead = [&](std::string_view key) -> const char* {
    for (const auto& [other, words] : own.instead)
      if (other == key) return words;
    return nullptr;
  };
  std::set<std::string_view> keys;
  for (const SolverMethod* m : solver_methods()) keys.insert(m->keys.begin(), m->keys.end());
  for (const std::string_view key : keys) {
    if (own.reads(key)) continue;
    const char* has = instead(key);
    out.unused(std::string(key), std::string(key),
               has ? fmt::format("{} {}; remove it", own.name, has) : readers_of(key));
  }
}

/// Reports an unused fluid.viscosity. Air drag reads it, too, for the deformation of drops.
void check_fluid_viscosity(const Scene& s, Findings& out) {
  if (s.viscosity_method() != ViscosityMethod::artificial || s.air.drag != Drag::none) return;
  for (std::size_t k = 0; k < s.fluid.size(); ++k)
    out.unused(fmt::format("fluid[{}].viscosity", k), "fluid.viscosity",
               fmt::format("{} has solver.artificial_viscosity instead, unless another "
                           "solver.viscosity_method is set; remove it",
                           s.method().name));
}

void check_iterations(const Scene& s, Findings& out) {
  if (s.method().incompressible() && s.solver.min_iterations.value_or(1) > s.solver.max_iterations)
    out.error("solver.min_iterations",
              fmt::format("solver.min_iterations is {}, above solver.max_iterations, {}; make it "
                          "smaller, or solver.max_iterations larger",
                          *s.solver.min_iterations, s.solver.max_iterations));
}

/// An output interval is set in seconds or in steps, but not in both. It is at least one step.
/// Adaptive steps are known when the fluid is sampled only: see scene_warnings.
void check_every(const Scene& s, const std::string& key, std::optional<std::int64_t> steps,
                 std::optional<double> seconds, Findings& out) {
  const std::string key_steps = key + "_steps";
  if (steps && seconds)
    out.error(key, fmt::format("{} and {} are both set; keep one", key, key_steps));
  if (seconds && !s.time.adaptive && *seconds < s.time.step)
    out.error(key, fmt::format("{} is {} s, shorter than a time step, {} s; make it longer", key,
                               *seconds, s.time.step));
}

/// The number of frames is limited.
void check_count(const Scene& s, const std::string& key, std::optional<std::int64_t> every_steps,
                 std::optional<double> every, Findings& out) {
  const double steps = std::round(s.time.end / s.time.step);
  const auto too_many = [&](const std::string& given, double frames) {
    out.error(given, fmt::format("the run would write {:.4g} frames; at most {:.0f} are allowed; "
                                 "make {} larger",
                                 frames, most_frames, given));
  };
  const double per = double(every_steps.value_or(0));
  if (!s.time.adaptive && per > 0 && steps <= most_steps && steps / per > most_frames)
    too_many(key + "_steps", steps / per);
  else if (every && s.time.end / *every > most_frames) too_many(key, s.time.end / *every);
}

/// The keys of data files.
void check_data(const Scene& s, Findings& out) {
  const auto& data = s.output.data;
  const bool paces_meshes = s.surface && !s.surface->every && !s.surface->every_steps;
  if (data.empty())
    for (const char* key :
         {"output.fields", "output.precision", "output.data_every", "output.data_every_steps"}) {
      if (paces_meshes && std::string_view(key).starts_with("output.data_every")) continue;
      out.unused(key, key,
                 "output.data is empty, so that no data files are written; remove it, or name a "
                 "format there");
    }
  else if (s.output.precision == Precision::float16)
    for (const DataFormat format : data)
      if (format != DataFormat::hdf5)
        return out.error(
            "output.precision",
            fmt::format("output.precision = \"float16\" needs hdf5, and output.data {} "
                        "\"{}\"; set output.data = [\"hdf5\"], or choose \"float32\"",
                        out.given("output.data") ? "has" : "is", data_words[int(format)]));
}

}  // namespace

void check_method(const Scene& s, Findings& out) {
  check_backend(s, out);
  check_keys_of_solvers(s, out);
  check_fluid_viscosity(s, out);
  check_iterations(s, out);
  if (s.method().reads("solver.delta") && s.density_diffusion() == DensityDiffusion::none)
    out.unused("solver.delta", "solver.delta", "solver.density_diffusion is \"none\"; remove it");
  const bool has_schemes = s.method().reads("solver.scheme");
  if (s.is_article()) {
    if (!s.particles.mass)
      out.error("solver.scheme",
                "solver.scheme = \"article\" needs particles.mass (0.02 in the article); "
                "set it, or choose \"paper\", which derives it");
    return;
  }
  out.unused("particles.mass", "particles.mass",
             fmt::format("{} it is rest_density × spacing{}; remove it",
                         has_schemes ? "with solver.scheme = \"paper\"" : "here",
                         s.dimension() == 3 ? "³" : "²"));
  if (has_schemes)
    out.unused("solver.speed_limit", "solver.speed_limit",
               "only solver.scheme = \"article\" has one; remove it");
}

void check_body_force(const Scene& s, Findings& out) {
  const std::vector<std::string>& force = s.domain.body_force;
  if (force.empty()) return;
  if (int(force.size()) != s.dimension())
    out.error("domain.body_force",
              fmt::format("domain.body_force has {} functions; it must have {}, one per axis",
                          force.size(), s.dimension()));
  else if (const auto fault = fault_in(force))
    out.error("domain.body_force", "domain.body_force " + *fault);
  if (s.is_article())
    out.error("domain.body_force",
              "domain.body_force is set, and solver.scheme is \"article\", which has gravity "
              "only; remove it, or choose solver.scheme = \"paper\"");
}

void check_gravity(const Scene& s, Findings& out) {
  if (!is_weightless(s)) return;
  if (s.method().reads("solver.stiffness") && !s.solver.stiffness)
    out.error("domain.gravity",
              "without gravity, solver.stiffness has no default; set it (the square of ten times "
              "the maximum speed is a good start)");
  if (s.method().reads("solver.sound_speed") && !s.solver.sound_speed)
    out.error("domain.gravity",
              "without gravity, solver.sound_speed has no default; set it (ten times the maximum "
              "speed is a good start)");
  for (std::size_t k = 0; k < s.fluid.size(); ++k)
    if (s.fluid[k].pressure == StartPressure::hydrostatic)
      out.error(fmt::format("fluid[{}].pressure", k),
                "fluid.pressure = \"hydrostatic\" needs gravity; set domain.gravity, or choose "
                "\"zero\"");
}

/// The article's scheme has one box of fluid in 2D, reflecting sides and fixed steps.
void check_scheme(const Scene& s, Findings& out) {
  if (!s.is_article()) return;
  const char* remedy = "remove it, or choose solver.scheme = \"paper\"";
  if (s.dimension() == 3)
    out.error("solver.scheme",
              "solver.scheme = \"article\" supports 2D only, and domain.max has 3 numbers; choose "
              "\"paper\"");
  for (const char* key : {"domain.periodic", "time.integrator"})
    out.unused(key, key,
               fmt::format("solver.scheme is \"article\", which has its own; {}", remedy));
  if (s.time.adaptive)
    out.error("time.step",
              "time.step is \"adaptive\", and solver.scheme = \"article\" needs a "
              "fixed step; set a number, or choose \"paper\"");
  if (!s.wall.empty())
    out.error("wall[0]", fmt::format("solver.scheme = \"article\" supports no walls except the "
                                     "sides of the domain; {}",
                                     remedy));
  for (int side = 0; side < 2 * s.dimension(); ++side)
    if (s.side_method(side) != WallMethod::reflection) {
      const std::string key = "walls." + s.wall_names()[std::size_t(side)];
      out.error(out.given(key) ? key : "walls.method",
                "solver.scheme = \"article\" supports \"reflection\" walls only; choose that, or "
                "solver.scheme = \"paper\"");
      break;
    }
}

void check_time(const Scene& s, Findings& out) {
  if (s.time.adaptive && !s.time.step_max)
    return out.error("time.step",
                     "time.step = \"adaptive\" needs time.step_max, the maximum step (s); add it");
  if (!s.time.adaptive)
    out.unused("time.step_max", "time.step_max",
               "time.step is a number; remove it, or set time.step = \"adaptive\"");
  const char* key = s.time.adaptive ? "time.step_max" : "time.step";
  const double step = s.time.adaptive ? *s.time.step_max : s.time.step;
  const double steps = std::round(s.time.end / step);
  if (!(steps >= 1))
    out.error(key, fmt::format("{} is {} s, longer than the whole run, {} s; make it smaller", key,
                               step, s.time.end));
  if (steps > most_steps)
    out.error(key, fmt::format("the run would take {:.4g} steps; at most {:.0f} are allowed; make "
                               "{} larger or time.end smaller",
                               steps, most_steps, key));
}

void check_surface_meshes(const Scene& s, Findings& out) {
  if (!s.surface) return;
  if (s.dimension() == 2)
    return out.error("surface", "[surface] needs a scene in 3D, and this one is in 2D; remove it");
  const SurfaceSettings& settings = s.surface->settings;
  if (settings.cell > settings.radius / 2)
    out.error(out.given("surface.cell") ? "surface.cell" : "surface.radius",
              fmt::format("surface.cell is {} spacings, more than half of surface.radius, {}; a "
                          "coarser grid misses particles; make the cell smaller or the radius "
                          "larger",
                          settings.cell, settings.radius));
  if (settings.simplify > 0 && !simplifies_surfaces())
    out.error(
        "surface.simplify",
        "surface.simplify needs meshoptimizer, and this Freshet was built without it; install "
        "libmeshoptimizer-dev and rebuild, or remove it");
  check_every(s, "surface.every", s.surface->every_steps, s.surface->every, out);
  check_count(s, "surface.every", s.surface->every_steps, s.surface->every, out);
}

void check_output(const Scene& s, Findings& out) {
  check_every(s, "output.frame_every", s.output.frame_every_steps, s.output.frame_every, out);
  check_every(s, "output.data_every", s.output.data_every_steps, s.output.data_every, out);
  check_every(s, "output.observables_every", s.output.observables_every_steps,
              s.output.observables_every, out);
  check_every(s, "output.checkpoint_every", s.output.checkpoint_every_steps,
              s.output.checkpoint_every, out);
  check_data(s, out);
  check_count(s, "output.frame_every", s.output.frame_every_steps, s.output.frame_every, out);
  check_count(s, "output.data_every", s.output.data_every_steps, s.output.data_every, out);
}

}  // namespace freshet
