// SPDX-License-Identifier: MIT
/// The solver, the time and the output.
#include <algorithm>
#include <cmath>
#include <initializer_list>

#include "scene/model/expressions.h"
#include "scene/check/findings.h"
#include "scene/keys/keys.h"

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
              "solver.neighbor_order = \"id\" is the reference's only; set "
              "solver.backend = \"reference\", or choose \"cell\"");
  if (s.solver.search == Search::all_pairs)
    out.error("solver.search",
              "solver.search = \"all_pairs\" is the reference's only; set "
              "solver.backend = \"reference\", or choose \"grid\"");
}

/// Keys that the solver does not read, with what it `has` in their place.
class UnusedKeys {
 public:
  UnusedKeys(const Scene& s, Findings& out)
      : fluids_(s.fluid.size()), solver_(solver_words[int(s.solver.name)]), out_(out) {}

  void has(const char* key, const std::string& instead) const { tell(key, key, instead); }
  void has_viscosity(const char* instead) const {
    for (std::size_t k = 0; k < fluids_; ++k)
      tell(fmt::format("fluid[{}].viscosity", k), "fluid.viscosity", instead);
  }
  void belongs_to(const std::string& solver, const char* key) const {
    out_.unused(
        key, key,
        fmt::format("only {0} reads it; remove it, or choose solver.name = \"{0}\"", solver));
  }
  void belong_to(const char* solvers, std::initializer_list<const char*> keys) const {
    for (const char* key : keys)
      out_.unused(
          key, key,
          fmt::format("only {} read it; remove it, or choose one of them as solver.name", solvers));
  }

 private:
  void tell(const std::string& path, const char* key, const std::string& instead) const {
    out_.unused(path, key, fmt::format("{} {}; remove it", solver_, instead));
  }

  std::size_t fluids_;
  std::string solver_;
  Findings& out_;
};

void check_mueller2003_keys(const UnusedKeys& unused) {
  unused.has("solver.kernel", "has the kernels of its paper");
  unused.belong_to("wcsph and delta_sph", {"solver.sound_speed", "solver.artificial_viscosity",
                                           "solver.background_pressure"});
}

/// What mueller2003 alone has.
void check_scheme_keys(const UnusedKeys& unused) {
  unused.has("solver.scheme", "has one scheme");
  unused.has("solver.speed_limit", "has none");
}

void check_weakly_compressible_keys(const Scene& s, const UnusedKeys& unused) {
  check_scheme_keys(unused);
  unused.has("solver.stiffness", "has solver.sound_speed instead");
  // drops flatten in the air by it
  if (s.viscosity_method() == ViscosityMethod::artificial && s.air.drag == Drag::none)
    unused.has_viscosity(
        "has solver.artificial_viscosity instead, unless solver.viscosity_method is another");
}

void check_pressure_keys(const Scene& s, const UnusedKeys& unused, Findings& out) {
  check_scheme_keys(unused);
  unused.has("solver.stiffness", "solves for the pressure, without an equation of state");
  unused.has("solver.sound_speed", "solves for the pressure, without sound");
  unused.has("solver.background_pressure", "solves for the pressure, without an equation of state");
  unused.has("solver.artificial_viscosity", "has fluid.viscosity instead");
  unused.has("time.integrator", "has an integrator of its own");
  if (s.solver.min_iterations > s.solver.max_iterations)
    out.error("solver.min_iterations",
              fmt::format("solver.min_iterations is {}, above solver.max_iterations, {}; make it "
                          "smaller, or solver.max_iterations larger",
                          s.solver.min_iterations, s.solver.max_iterations));
}

/// Keys of solvers that solve for the pressure.
void check_iteration_keys(const Scene& s, const UnusedKeys& unused) {
  const SolverName name = s.solver.name;
  if (!s.solver.incompressible())
    unused.belong_to("pcisph, iisph, dfsph and pbf",
                     {"solver.density_tolerance", "solver.min_iterations", "solver.max_iterations",
                      "solver.xsph", "time.retry"});
  if (name != SolverName::iisph && name != SolverName::dfsph)
    unused.belong_to("iisph and dfsph", {"solver.warm_start"});
  if (name == SolverName::dfsph) return;
  unused.belongs_to("dfsph", "solver.divergence_tolerance");
  unused.belongs_to("dfsph", "solver.iteration");
}

/// Seconds between what is written, or steps, but not both; never less than a step.
void check_every(const Scene& s, const char* name, std::optional<std::int64_t> steps,
                 std::optional<double> seconds, Findings& out) {
  const std::string key = fmt::format("output.{}", name), key_steps = key + "_steps";
  if (steps && seconds)
    out.error(key, fmt::format("{} and {} say the same twice; keep one", key, key_steps));
  else if (steps && s.time.adaptive)
    out.error(key_steps, fmt::format("{} counts steps, and how many there are is not known while "
                                     "time.step is \"adaptive\"; give {} in seconds",
                                     key_steps, key));
  const double step = s.time.adaptive ? s.time.step_max.value_or(0) : s.time.step;
  if (seconds && *seconds < step)
    out.error(key, fmt::format("{} is {} s, shorter than a time step, {} s; make it longer", key,
                               *seconds, step));
}

/// Not too many of them.
void check_count(const Scene& s, const char* name, std::optional<std::int64_t> every_steps,
                 std::optional<double> every, Findings& out) {
  const double steps = std::round(s.time.end / s.time.step);
  const std::string key = fmt::format("output.{}", name);
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

/// The data files.
void check_data(const Scene& s, Findings& out) {
  const auto& data = s.output.data;
  if (data.empty())
    for (const char* key : {"fields", "precision", "data_every", "data_every_steps"})
      out.unused(fmt::format("output.{}", key), fmt::format("output.{}", key),
                 "output.data is empty, so that no data files are written; remove it, or name a "
                 "format there");
  else if (s.output.precision == Precision::float16)
    for (const DataFormat format : data)
      if (format != DataFormat::hdf5)
        return out.error(
            "output.precision",
            fmt::format("output.precision = \"float16\" is hdf5's only, and output.data {} "
                        "\"{}\"; set output.data = [\"hdf5\"], or choose \"float32\"",
                        out.given("output.data") ? "has" : "is", data_words[int(format)]));
}

}  // namespace

void check_method(const Scene& s, Findings& out) {
  check_backend(s, out);
  const bool mueller = s.solver.name == SolverName::mueller2003;
  const UnusedKeys unused(s, out);
  if (mueller) check_mueller2003_keys(unused);
  else if (s.solver.incompressible()) check_pressure_keys(s, unused, out);
  else check_weakly_compressible_keys(s, unused);
  check_iteration_keys(s, unused);
  if (s.solver.name != SolverName::delta_sph)
    for (const char* key : {"density_diffusion", "delta"})
      out.unused(fmt::format("solver.{}", key), fmt::format("solver.{}", key),
                 "only delta_sph diffuses density; remove it, or choose solver.name = "
                 "\"delta_sph\"");
  else if (s.density_diffusion() == DensityDiffusion::none)
    out.unused("solver.delta", "solver.delta", "solver.density_diffusion is \"none\"; remove it");
  const bool article = mueller && s.solver.scheme == Scheme::article;
  if (article) {
    if (!s.particles.mass)
      out.error("solver.scheme",
                "solver.scheme = \"article\" needs particles.mass; the article has "
                "0.02 (or choose \"paper\", which derives it)");
    return;
  }
  out.unused("particles.mass", "particles.mass",
             fmt::format("{} it is rest_density × spacing{}; remove it",
                         mueller ? "with solver.scheme = \"paper\"" : "here",
                         s.dimension() == 3 ? "³" : "²"));
  if (mueller)
    out.unused("solver.speed_limit", "solver.speed_limit",
               "only solver.scheme = \"article\" has one; remove it");
}

void check_body_force(const Scene& s, Findings& out) {
  const std::vector<std::string>& force = s.domain.body_force;
  if (force.empty()) return;
  if (int(force.size()) != s.dimension())
    out.error("domain.body_force",
              fmt::format("domain.body_force has {} functions; give {}, as domain.max has numbers",
                          force.size(), s.dimension()));
  else if (const auto fault = fault_in(force))
    out.error("domain.body_force", "domain.body_force " + *fault);
  if (s.solver.name == SolverName::mueller2003 && s.solver.scheme == Scheme::article)
    out.error("domain.body_force",
              "domain.body_force is given, and solver.scheme is \"article\", which has gravity "
              "only; remove it, or choose solver.scheme = \"paper\"");
}

void check_gravity(const Scene& s, Findings& out) {
  if (!is_weightless(s)) return;
  const bool mueller = s.solver.name == SolverName::mueller2003;
  const bool weakly = !mueller && !s.solver.incompressible();
  if (mueller && !s.solver.stiffness)
    out.error("domain.gravity",
              "without gravity there is no default of solver.stiffness; give solver.stiffness "
              "(the square of ten times the fastest speed is a good start)");
  if (weakly && !s.solver.sound_speed)
    out.error("domain.gravity",
              "without gravity there is no default of solver.sound_speed; give solver.sound_speed "
              "(ten times the fastest speed is a good start)");
  for (std::size_t k = 0; k < s.fluid.size(); ++k)
    if (s.fluid[k].pressure == StartPressure::hydrostatic)
      out.error(fmt::format("fluid[{}].pressure", k),
                "fluid.pressure = \"hydrostatic\" needs gravity; give domain.gravity, or choose "
                "\"zero\"");
}

/// The article has one box, in 2D, and steps of its own.
void check_scheme(const Scene& s, Findings& out) {
  if (s.solver.name != SolverName::mueller2003 || s.solver.scheme != Scheme::article) return;
  const char* remedy = "remove it, or choose solver.scheme = \"paper\"";
  if (s.dimension() == 3)
    out.error("solver.scheme",
              "solver.scheme = \"article\" is in 2D, and domain.max has 3 numbers; choose "
              "\"paper\"");
  for (const char* key : {"domain.periodic", "time.integrator"})
    out.unused(key, key,
               fmt::format("solver.scheme is \"article\", which has its own; {}", remedy));
  if (s.time.adaptive)
    out.error("time.step",
              "time.step is \"adaptive\", and solver.scheme = \"article\" has steps "
              "of one length; give a number, or choose \"paper\"");
  if (!s.wall.empty())
    out.error("wall[0]", fmt::format("solver.scheme = \"article\" has the sides of the domain, and "
                                     "no other wall; {}",
                                     remedy));
  for (int side = 0; side < 2 * s.dimension(); ++side)
    if (s.side_method(side) != WallMethod::reflection) {
      const std::string key = "walls." + s.wall_names()[std::size_t(side)];
      out.error(out.given(key) ? key : "walls.method",
                "solver.scheme = \"article\" has walls of \"reflection\" only; choose that, or "
                "solver.scheme = \"paper\"");
      break;
    }
}

void check_time(const Scene& s, Findings& out) {
  if (s.time.adaptive && !s.time.step_max)
    return out.error("time.step",
                     "time.step = \"adaptive\" needs time.step_max, the longest step (s); add it");
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

void check_output(const Scene& s, Findings& out) {
  check_every(s, "frame_every", s.output.frame_every_steps, s.output.frame_every, out);
  check_every(s, "data_every", s.output.data_every_steps, s.output.data_every, out);
  check_every(s, "observables_every", s.output.observables_every_steps, s.output.observables_every,
              out);
  check_every(s, "checkpoint_every", s.output.checkpoint_every_steps, s.output.checkpoint_every,
              out);
  check_data(s, out);
  check_count(s, "frame_every", s.output.frame_every_steps, s.output.frame_every, out);
  check_count(s, "data_every", s.output.data_every_steps, s.output.data_every, out);
}

}  // namespace freshet
