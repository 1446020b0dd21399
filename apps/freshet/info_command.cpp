// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cmath>

#include "command.h"
#include "freshet/checkpoint_file.h"
#include "freshet/derived.h"
#include "freshet/simulation.h"
#include "freshet/units.h"
#include "machine.h"
#include "print.h"
#include "progress.h"
#include "volume_row.h"

namespace freshet::cli {
namespace {

/// Measured over a fifth of a second of steps.
struct Cost {
  double seconds_per_step;
  double particles;  ///< at the end of these steps
  double steps, time;
  double checkpoint_bytes;
};

Cost measure(const Scene& scene, const Execution& execution) {
  using Clock = std::chrono::steady_clock;
  Simulation sim(scene, execution);
  const auto start = Clock::now();
  double seconds = 0;
  while (seconds < 0.2 && !sim.finished()) {
    sim.step();
    seconds = std::chrono::duration<double>(Clock::now() - start).count();
  }
  return {seconds / double(sim.steps_done()), double(sim.fluid().size()), double(sim.steps_done()),
          sim.time(), double(checkpoint_bytes(sim))};
}

/// The adaptive step of a fluid that moves half as fast as the scene lets it [s].
double likely_step(const Scene& s, const Derived& d) {
  const double c = d.sound_speed, speed = c / 20, h = d.support_radius / 2;
  const double moving = s.method().incompressible() ? (speed > 0 ? 0.4 * h / speed : d.flow_step)
                                                    : d.acoustic_step * c / (c + speed);
  return std::min({*s.time.step_max, d.step_bound(), moving});
}

/// How many steps a run takes; `measured` of them are known.
double likely_steps(const Scene& s, const Derived& d, const Cost& measured) {
  if (!s.time.adaptive) return double(s.steps());
  const double left = s.time.end - measured.time;
  const double mean = measured.time / measured.steps;
  const bool enough = measured.time > 0.05 * s.time.end;  // to tell the rest of the run
  return measured.steps + std::max(0.0, left) / (enough ? mean : likely_step(s, d));
}

/// The wall time of a run [s]. The cost of a step grows with the particles that inlets add.
double likely_seconds(const Derived& d, const Cost& cost, double steps) {
  constexpr double alone = 500;  // particles whose cost a step without any has
  const double mean = (d.particles + d.most_particles) / 2;
  return steps * cost.seconds_per_step * (mean + alone) / (cost.particles + alone);
}

void row(const char* name, const std::string& value) {
  print_out("  {:<24}{}\n", name, printable(value));
}

std::string bound(double seconds) {
  return std::isfinite(seconds) ? fmt::format("{:.3g} s", seconds) : "none";
}

std::string kernel_word(KernelName kernel) {
  static constexpr const char* words[] = {"cubic spline", "Wendland C2", "Wendland C4",
                                          "Wendland C6"};
  return words[int(kernel)];
}

std::string solver_row(const Scene& s) {
  const SolverMethod& m = s.method();
  const std::string kernel =
      m.has_own_kernels() ? "kernels Poly6 and Spiky" : "kernel " + kernel_word(s.solver.kernel);
  const char* iteration = !m.reads("solver.iteration")              ? ""
                          : s.solver.iteration == Iteration::jacobi ? "Jacobi, "
                                                                    : "Nesterov, ";
  return fmt::format("{} ({}), {}{}", m.name, m.paper, iteration, kernel);
}

std::string percent(double share) { return fmt::format("{:.4g} %", 100 * share); }

/// What a solve for the pressure comes to, and what it takes at most.
std::string tolerance_row(const Scene& s, const Derived& d) {
  const std::string divergence =
      s.method().reads("solver.divergence_tolerance")
          ? fmt::format(", of divergence {} in a step", percent(d.divergence_tolerance))
          : "";
  return fmt::format("of density {}{}; {} to {} iterations a solve", percent(d.density_tolerance),
                     divergence, s.solver.min_iterations.value_or(1), s.solver.max_iterations);
}

std::string sound_row(const Scene& s, const Derived& d) {
  const bool is_set = s.solver.sound_speed || s.solver.stiffness;
  const std::string speed =
      fmt::format("{:.4g} m/s{}", d.sound_speed,
                  is_set ? "" : ", ten times the fastest flow: a fall, a start, a body or a wall");
  return s.method().reads("solver.stiffness")
             ? fmt::format("{} (stiffness {:.4g} m²/s²)", speed, d.stiffness)
             : speed;
}

std::string particles_row(const Derived& d) {
  std::string text = fmt::format("{:.0f} fluid", d.particles);
  if (d.outside > 0) text += fmt::format(", {} of them outside the domain", d.outside);
  if (d.wall_particles > 0) text += fmt::format("; {} of walls", d.wall_particles);
  if (d.most_particles > d.particles)
    text += fmt::format("; at most {:.0f}, with those of inlets", d.most_particles);
  if (d.left_out > 0)
    text += fmt::format("; {} places inside walls{} excluded", d.left_out,
                        d.inlets.empty() ? "" : " and inlets");
  return text;
}

std::string inlet_row(const Scene& s, const DerivedInlet& in) {
  return fmt::format(
      "{}: {:.4g} {} at {:.4g} m/s, {:.0f} particles a layer, {:.4g} layers a second", in.name,
      in.rate, raised_unit(units_in(s.dimension()).flow_rate), in.speed, in.particles,
      in.speed / s.particles.spacing);
}

std::string whitewater_row(const Scene& s, const Derived& d) {
  return fmt::format("maximum speed {:.4g} m/s; at most {:.0f} particles", d.fastest,
                     d.whitewater(s));
}

std::string time_step_row(const Scene& s, const Derived& d) {
  const std::string step = s.time.adaptive
                               ? fmt::format("adaptive, at most {:g} s", *s.time.step_max)
                               : fmt::format("{:g} s", s.time.step);
  const std::string fastest = s.method().incompressible()
                                  ? "flow at the start " + bound(d.flow_step)
                                  : "sound " + bound(d.acoustic_step);
  const std::string tension =
      std::isfinite(d.capillary_step) ? ", surface tension " + bound(d.capillary_step) : "";
  return fmt::format("{}; bounds: {}, gravity {}, viscosity {}{}", step, fastest,
                     bound(d.force_step), bound(d.viscous_step), tension);
}

/// Pictures are at most as large as their pixels.
std::string disk_row(const Scene& s, const Derived& d) {
  const double pictures = 3.0 * double(d.picture_width * d.picture_height) * double(d.frames + 1);
  std::string text =
      fmt::format("at most {}B for {} frames and the result", short_number(pictures), d.frames);
  if (d.data_frames > 0)
    text += fmt::format("; about {}B for the data of {}{}", short_number(d.data_bytes),
                        d.data_frames, s.whitewater ? ", whitewater not counted" : "");
  if (d.surface_frames > 0)
    text += fmt::format("; {} {}B for the surfaces of {}, if their area stays",
                        s.surface->settings.simplify > 0 ? "at most" : "about",
                        short_number(d.surface_bytes), d.surface_frames);
  return text;
}

void info(const SceneArguments& a) {
  thread_count(a.threads);  // an error before anything is sampled
  const Scene s = a.load();
  const Derived d = derive(s);
  const int threads = thread_count(a.threads, d.most_particles);
  const Units units = units_in(s.dimension());
  const std::string density = raised_unit(units.density);
  print_out("{}\n", printable(s.title.empty() ? a.name : s.title));
  row("dimension", fmt::format("{}D", s.dimension()));
  row("particles", particles_row(d));
  for (std::size_t k = 0; k < d.fluids.size(); ++k)
    row(volume_name(d, k).c_str(), volume_row(s, d.fluids[k]));
  for (const DerivedInlet& in : d.inlets) row("inlet", inlet_row(s, in));
  row("method", solver_row(s));
  row("spacing", fmt::format("{:g} m", d.spacing));
  row("support radius",
      fmt::format("{:g} m = {:.3g} spacings", d.support_radius, d.support_radius / d.spacing));
  row("neighbours expected", fmt::format("{:.0f} in the resting lattice", d.neighbors));
  row("lattice errors",
      fmt::format("density {:+.1f} %{}, pressure gradient {:+.1f} %", 100 * d.density_error,
                  s.particles.mass ? "" : " (divided out)", 100 * d.gradient_error));
  row("mass", fmt::format("{:.6g} {}{}", d.mass, units.mass, s.particles.mass ? " (set)" : ""));
  row("density at rest", fmt::format("{:.6g} {} where the lattice is whole; rest density {:g} {}",
                                     d.mass / std::pow(d.spacing, s.dimension()) *
                                         (1 + d.density_error) / d.lattice_sum,
                                     density, d.rest_density, density));
  if (s.method().incompressible()) row("tolerances", tolerance_row(s, d));
  else row("speed of sound", sound_row(s, d));
  if (s.whitewater) row("whitewater", whitewater_row(s, d));
  row("time step", time_step_row(s, d));
  const Cost cost = measure(s, a.execution());
  const double steps = likely_steps(s, d, cost);
  row("steps", s.time.adaptive ? fmt::format("about {} for {:g} s", short_number(steps), s.time.end)
                               : fmt::format("{} for {:g} s", s.steps(), s.time.end));
  if (s.solver.backend == BackendName::cpu)
    row("computed by",
        fmt::format("{} thread{}, {}", threads, threads == 1 ? "" : "s", instruction_set(a.isa)));
  else row("computed by", "one thread, scalar (reference)");
  row("run time", fmt::format("about {} on this machine ({:.3g} ms a step, measured{})",
                              duration(likely_seconds(d, cost, steps)), 1e3 * cost.seconds_per_step,
                              d.inlets.empty() ? "" : "; more with inlets"));
  row("memory", fmt::format("{}B", short_number(peak_memory())));
  row("disk", disk_row(s, d) + fmt::format("; {}B for two checkpoints",
                                           short_number(2 * cost.checkpoint_bytes)));
  print_diagnostics(scene_warnings(s));
}

}  // namespace

void add_info(Program& program) {
  const auto a = std::make_shared<SceneArguments>();
  const Command command =
      program.add("info", "Print the numbers of a scene and the cost of its run");
  a->add_to(command);
  command.footer("Example:\n  freshet info article");
  command.action([a] {
    info(*a);
    return done;
  });
}

}  // namespace freshet::cli
