// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <nlohmann/json.hpp>
#include <sstream>

#include "command.h"
#include "freshet/derived.h"
#include "freshet/simulation.h"
#include "machine.h"
#include "print.h"
#include "progress.h"

namespace freshet::cli {
namespace {

using Json = nlohmann::ordered_json;

struct BenchArguments {
  SceneArguments scene;
  double particles = 0;
  std::string compare;
  std::int64_t steps = 0;
  int repeats = 3;
  bool json = false, markdown = false;
};

struct Measured {
  double particles = 0, wall_particles = 0, steps = 0, seconds = INFINITY, bytes = 0;
  double time = 0, density_error = 0;  // simulated [s]; mean at the end, a fraction
  std::int64_t retried = 0;
  std::vector<SolveStatistics> solves;
  std::vector<VerbTiming> verbs;
  std::string state_sha256;

  double particle_steps_per_second() const { return particles * steps / seconds; }
  /// Of all solves.
  double iterations() const {
    double sum = 0;
    for (const SolveStatistics& s : solves) sum += double(s.iterations);
    return sum;
  }
  /// That the solves themselves took, as far as the names of the verbs tell; else 0.
  double solve_seconds() const {
    double sum = 0;
    for (const VerbTiming& v : verbs)
      if (v.name.starts_with("solve: ")) sum += v.seconds;
    return sum;
  }
};

double ns_per_particle(const VerbTiming& v) {
  return v.targets ? 1e9 * v.seconds / double(v.targets) : 0;
}

Scene bench_scene(const BenchArguments& a, std::vector<Override> overrides,
                  const std::vector<Override>& extra) {
  overrides.insert(overrides.end(), extra.begin(), extra.end());
  const auto file = find_scene(a.scene.name);
  if (a.particles > 0) {
    const auto more = at_resolution(load_scene(file, overrides), a.particles);
    overrides.insert(overrides.end(), more.begin(), more.end());
  }
  return load_scene(file, overrides);
}

/// One more repeat of so many steps, or to the end where 0 are asked for; the fastest counts.
void measure(const Scene& scene, const Execution& execution, std::int64_t steps, Measured& best) {
  const double before = peak_memory();
  Simulation sim(scene, execution);
  const auto start = std::chrono::steady_clock::now();
  while (steps ? sim.steps_done() < steps : !sim.finished()) sim.step();
  const double seconds =
      std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  best.bytes = std::max(best.bytes, peak_memory() - before);  // the first repeat grows the process
  if (seconds >= best.seconds) return;
  best.particles = double(sim.fluid().size());
  best.wall_particles = double(derive(scene).wall_particles);
  best.steps = double(sim.steps_done());
  best.seconds = seconds;
  best.time = sim.time();
  best.density_error = sim.statistics().density_error_mean;
  best.retried = sim.time_steps().retried;
  best.solves = sim.solves();
  best.verbs = sim.timings();
  best.state_sha256 = sim.state_sha256();
}

/// An iteration is both of its passes over the particles. Errors are fractions.
Json solves_to_json(const Measured& m) {
  Json out{{"iterations", m.iterations() / m.steps},
           {"particle_iterations_per_second", m.particles * m.iterations() / m.seconds}};
  if (m.solve_seconds() > 0)
    out["solve_particle_iterations_per_second"] = m.particles * m.iterations() / m.solve_seconds();
  out["retried"] = m.retried;
  for (const SolveStatistics& s : m.solves) {
    out[s.name + "_iterations"] = s.mean_iterations();
    out[s.name + "_error"] = s.last_error;
    out[s.name + "_error_worst"] = s.worst_error;
    out[s.name + "_not_converged"] = s.not_converged;
  }
  return out;
}

Json to_json(const Measured& m, const std::string& value) {
  Json verbs = Json::object();
  for (const VerbTiming& v : m.verbs) verbs[v.name] = ns_per_particle(v);
  const double all = m.particles + m.wall_particles;
  Json out;
  if (!value.empty()) out["value"] = value;
  out.update({{"fluid_particles", std::int64_t(m.particles)},
              {"wall_particles", std::int64_t(m.wall_particles)},
              {"steps", std::int64_t(m.steps)},
              {"seconds", m.seconds},
              {"time", m.time},
              {"particle_steps_per_second", m.particle_steps_per_second()},
              {"all_particle_steps_per_second", all * m.steps / m.seconds},
              {"bytes_per_particle", m.bytes / all},
              {"verbs", verbs},
              {"state_sha256", m.state_sha256}});
  if (!m.solves.empty()) out.update(solves_to_json(m));
  return out;
}

void print_solves(const Measured& m) {
  for (const SolveStatistics& s : m.solves) print_out("  {}: {}\n", s.name, solve_words(s));
  if (m.solves.empty()) return;
  print_out("  {:.3g} iterations a step, {} particle-iterations/s", m.iterations() / m.steps,
            short_number(m.particles * m.iterations() / m.seconds));
  if (m.solve_seconds() > 0)
    print_out(", {} in the solves alone",
              short_number(m.particles * m.iterations() / m.solve_seconds()));
  print_out("{}\n", m.retried ? fmt::format("; {} steps halved", m.retried) : "");
}

/// One row a value, for a document.
void print_markdown(const std::string& key, const std::vector<std::string>& values,
                    const std::vector<Measured>& all) {
  print_out(
      "| `{}` | time step [ms] | iterations a step | density error [%] | error of the solve [%] | "
      "wall time [s] | wall time for one simulated second [s] | particle-steps/s |\n|{}\n",
      key, "---|---|---|---|---|---|---|---|");
  for (std::size_t k = 0; k < all.size(); ++k) {
    const Measured& m = all[k];
    const auto density = std::find_if(m.solves.begin(), m.solves.end(),
                                      [](const auto& s) { return s.name == "density"; });
    const bool solved = density != m.solves.end();
    print_out("| `{}` | {:.3g} | {} | {:.3g} | {} | {:.3g} | {:.3g} | {} |\n", values[k],
              1000 * m.time / m.steps,
              solved ? fmt::format("{:.3g}", m.iterations() / m.steps) : "", 100 * m.density_error,
              solved ? fmt::format("{:.3g}", 100 * density->last_error) : "", m.seconds,
              m.seconds / m.time, short_number(m.particle_steps_per_second()));
  }
}

/// How wide the column of the verbs is.
std::size_t widest_name(const std::vector<VerbTiming>& verbs) {
  std::size_t widest = 14;
  for (const VerbTiming& v : verbs) widest = std::max(widest, v.name.size() + 1);
  return widest;
}

void print_table(const std::vector<std::string>& values, const std::vector<Measured>& all,
                 const Ceilings& c) {
  for (std::size_t k = 0; k < all.size(); ++k) {
    const Measured& m = all[k];
    print_out("{}{:.0f} particles, {:.0f} steps: {:.4g} s, {} particle-steps/s",
              values[k].empty() ? "" : values[k] + ": ", m.particles, m.steps, m.seconds,
              short_number(m.particle_steps_per_second()));
    print_out(
        "{}\n",
        k == 0 ? "" : fmt::format("  ({:.2f} times the first's time)", m.seconds / all[0].seconds));
    print_solves(m);
    for (const VerbTiming& v : m.verbs)
      print_out("  {:<{}}{:>8.1f} ns a particle  {:>4.0f} %\n", v.name, widest_name(m.verbs),
                ns_per_particle(v), 100 * v.seconds / m.seconds);
  }
  print_out("this machine, one thread: {}flop/s, {}B/s\n", short_number(c.flops),
            short_number(c.bytes_per_second));
}

/// The values between commas.
std::vector<std::string> split(const std::string& text) {
  std::vector<std::string> values;
  std::istringstream in(text);
  for (std::string value; std::getline(in, value, ',');) values.push_back(value);
  return values;
}

void bench(const BenchArguments& a) {
  std::vector<std::string> values{""};
  std::string key;
  if (!a.compare.empty()) {
    const auto equals = a.compare.find('=');
    if (equals == std::string::npos || equals == 0)
      throw Error(Error::Kind::scene, "--compare " + a.compare,
                  "write KEY=A,B, for example solver.search=grid,all_pairs");
    key = a.compare.substr(0, equals);
    values = split(a.compare.substr(equals + 1));
  }
  const SceneChange change = a.scene.change();
  print_diagnostics(change.dropped);
  std::vector<Scene> scenes;
  for (const std::string& value : values)
    scenes.push_back(
        bench_scene(a, change.overrides,
                    key.empty() ? std::vector<Override>{} : std::vector<Override>{{key, value}}));
  std::vector<Measured> all(scenes.size());
  for (int repeat = 0; repeat < a.repeats; ++repeat)  // in turn, so that noise meets all alike
    for (std::size_t k = 0; k < scenes.size(); ++k)
      measure(scenes[k], a.scene.execution(), a.steps, all[k]);
  if (a.markdown) return print_markdown(key, values, all);
  const Ceilings c = measure_ceilings();
  if (!a.json) return print_table(values, all, c);
  const Json ceilings{{"flops", c.flops}, {"bytes_per_second", c.bytes_per_second}};
  Json out;
  if (key.empty()) out = to_json(all[0], "");
  for (std::size_t k = 0; k < all.size() && !key.empty(); ++k)
    out["runs"].push_back(to_json(all[k], values[k]));
  out["ceilings"] = ceilings;
  put(json_text(out, 2) + "\n");
}

}  // namespace

void add_bench(Program& program) {
  const auto a = std::make_shared<BenchArguments>();
  const Command command = program.add("bench", "Measure the speed of a scene, verb by verb");
  a->scene.add_to(command);
  command.option("--particles", a->particles, "about this many particles instead of the scene's")
      .range(1.0, 2e9);
  command.option("--steps", a->steps, "this many steps instead of the scene's")
      .range(1, 1000000000);
  command.option("--repeats", a->repeats, "take the fastest of this many (default: 3)")
      .range(1, 1000);
  const Option compare =
      command.option("--compare", a->compare, "one measurement per value of a key, taken in turn")
          .value("KEY=A,B");
  const Option json = command.flag("--json", a->json, "print JSON");
  command.flag("--markdown", a->markdown, "print the comparison as a table in Markdown")
      .needs(compare)
      .excludes(json);
  command.footer("Example:\n  freshet bench article --compare solver.search=grid,all_pairs");
  command.action([a] {
    bench(*a);
    return done;
  });
}

}  // namespace freshet::cli
