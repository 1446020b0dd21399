// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <chrono>
#include <cmath>
#include <nlohmann/json.hpp>

#include "command.h"
#include "freshet/derived.h"
#include "freshet/simulation.h"
#include "machine.h"
#include "progress.h"

namespace freshet::cli {
namespace {

using Json = nlohmann::ordered_json;

struct BenchArguments {
  SceneArguments scene;
  double particles = 0;
  std::string solver, compare;
  std::int64_t steps = 0;
  int repeats = 3;
  bool json = false;
};

struct Measured {
  double particles = 0, wall_particles = 0, steps = 0, seconds = INFINITY, bytes = 0;
  std::vector<VerbTiming> verbs;
  std::string state_sha256;
};

Scene bench_scene(const BenchArguments& a, const std::vector<Override>& extra) {
  auto overrides = a.scene.overrides();
  if (!a.solver.empty()) overrides.emplace_back("solver.name", fmt::format("\"{}\"", a.solver));
  overrides.insert(overrides.end(), extra.begin(), extra.end());
  const auto file = find_scene(a.scene.name);
  if (a.particles > 0) {
    const auto more = at_resolution(load_scene(file, overrides), a.particles);
    overrides.insert(overrides.end(), more.begin(), more.end());
  }
  return load_scene(file, overrides);
}

/// One more repeat; the fastest counts.
void measure(const Scene& scene, const Execution& execution, std::int64_t steps, Measured& best) {
  const double before = peak_memory();
  Simulation sim(scene, execution);
  const auto start = std::chrono::steady_clock::now();
  while (sim.steps_done() < steps) sim.step();
  const double seconds =
      std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  best.bytes = std::max(best.bytes, peak_memory() - before);  // the first repeat grows the process
  if (seconds >= best.seconds) return;
  best.particles = double(sim.fluid().size());
  best.wall_particles = double(derive(scene).wall_particles);
  best.steps = double(steps);
  best.seconds = seconds;
  best.verbs = sim.timings();
  best.state_sha256 = sim.state_sha256();
}

Json to_json(const Measured& m, const std::string& value) {
  Json verbs = Json::object();
  for (const VerbTiming& v : m.verbs) verbs[v.name] = 1e9 * v.seconds / double(v.targets);
  const double all = m.particles + m.wall_particles, rate = m.steps / m.seconds;
  Json out;
  if (!value.empty()) out["value"] = value;
  out.update({{"fluid_particles", std::int64_t(m.particles)},
              {"wall_particles", std::int64_t(m.wall_particles)},
              {"steps", std::int64_t(m.steps)},
              {"seconds", m.seconds},
              {"particle_steps_per_second", m.particles * rate},
              {"all_particle_steps_per_second", all * rate},
              {"bytes_per_particle", m.bytes / all},
              {"verbs", verbs},
              {"state_sha256", m.state_sha256}});
  return out;
}

void print_table(const std::vector<std::string>& values, const std::vector<Measured>& all,
                 const Ceilings& c) {
  for (std::size_t k = 0; k < all.size(); ++k) {
    const Measured& m = all[k];
    fmt::print("{}{:.0f} particles, {:.0f} steps: {:.4g} s, {} particle-steps/s",
               values[k].empty() ? "" : values[k] + ": ", m.particles, m.steps, m.seconds,
               short_number(m.particles * m.steps / m.seconds));
    fmt::print(
        "{}\n",
        k == 0 ? "" : fmt::format("  ({:.2f} times the first's time)", m.seconds / all[0].seconds));
    for (const VerbTiming& v : m.verbs)
      fmt::print("  {:<14}{:>8.1f} ns a particle  {:>4.0f} %\n", v.name,
                 1e9 * v.seconds / double(v.targets), 100 * v.seconds / m.seconds);
  }
  fmt::print("this machine, one thread: {}flop/s, {}B/s\n", short_number(c.flops),
             short_number(c.bytes_per_second));
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
    values = CLI::detail::split(a.compare.substr(equals + 1), ',');
  }
  std::vector<Scene> scenes;
  for (const std::string& value : values)
    scenes.push_back(bench_scene(
        a, key.empty() ? std::vector<Override>{} : std::vector<Override>{{key, value}}));
  std::vector<Measured> all(scenes.size());
  for (int repeat = 0; repeat < a.repeats; ++repeat)  // in turn, so that noise meets all alike
    for (std::size_t k = 0; k < scenes.size(); ++k)
      measure(scenes[k], a.scene.execution(), a.steps ? a.steps : scenes[k].steps(), all[k]);
  const Ceilings c = measure_ceilings();
  if (!a.json) return print_table(values, all, c);
  const Json ceilings{{"flops", c.flops}, {"bytes_per_second", c.bytes_per_second}};
  Json out;
  if (key.empty()) out = to_json(all[0], "");
  for (std::size_t k = 0; k < all.size() && !key.empty(); ++k)
    out["runs"].push_back(to_json(all[k], values[k]));
  out["ceilings"] = ceilings;
  fmt::print("{}\n", out.dump(2));
}

}  // namespace

void add_bench(CLI::App& app, int& code) {
  const auto a = std::make_shared<BenchArguments>();
  CLI::App* command = app.add_subcommand("bench", "Measure the speed of a scene, verb by verb");
  a->scene.add_to(*command);
  command->add_option("--particles", a->particles, "about so many particles instead of the scene's")
      ->check(CLI::Range(1.0, 2e9));
  command->add_option("--solver", a->solver, "another solver than the scene's");
  command->add_option("--steps", a->steps, "so many steps instead of the scene's")
      ->check(CLI::Range(1, 1000000000));
  command->add_option("--repeats", a->repeats, "the fastest of so many counts (default: 3)")
      ->check(CLI::Range(1, 1000));
  command->add_option("--compare", a->compare, "KEY=A,B: one measurement a value, taken in turn");
  command->add_flag("--json", a->json, "print JSON");
  command->footer("Example:\n  freshet bench article --compare solver.search=grid,all_pairs");
  command->callback([a, &code] {
    bench(*a);
    code = done;
  });
}

}  // namespace freshet::cli
