// SPDX-License-Identifier: MIT
#include "freshet/validate.h"

#include <fmt/format.h>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <fstream>
#include <iterator>
#include <mutex>
#include <thread>

#include "core/text.h"
#include "freshet/run.h"
#include "validation/measure.h"

namespace freshet {
namespace {

namespace fs = std::filesystem;

/// A run that is to be made.
struct Task {
  const ValidationCase* the_case;
  std::string solver;
  double spacing;
};

/// "3 spacings" as a length [m]; anything else as it is.
std::string in_metres(const std::string& value, double spacing) {
  const auto end = value.rfind(" spacings");
  const auto count = end == std::string::npos ? std::nullopt : number_in(value.substr(0, end));
  return count ? fmt::format("{}", *count * spacing) : value;
}

std::string bytes_of(const fs::path& file) {
  std::ifstream in(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), {}};
}

ValidationRun run_task(const Task& t, const ValidateOptions& options) {
  ValidationRun r;
  const ValidationCase& c = *t.the_case;
  r.case_name = c.name;
  r.solver = t.solver;
  r.spacing = t.spacing;
  for (const auto& [solver, why] : c.expected_failures)
    if (solver == t.solver) r.expected_failure = why;
  try {
    const Scene scene = load_scene(c.scene, overrides_of(c, t.solver, t.spacing));
    RunOptions run;
    run.output = options.output / fmt::format("{}_{}_{:g}", c.name, t.solver, t.spacing);
    run.overwrite = true;
    run.scene_name = c.name;
    run.command = {"freshet", "validate", c.name};
    run.execution.threads = options.jobs > 1 ? 1 : 0;
    const Report report = freshet::run(scene, run);
    r.particles = report.statistics.particles;
    r.steps = report.steps;
    r.seconds = report.seconds;
    r.picture = bytes_of(run.output / "result.png");
    for (ValidationMeasure m : c.measures) {
      if (options.short_form && m.short_bound) m.bound = m.short_bound;
      r.results.push_back(measure(c, m, run.output));
    }
  } catch (const Error& e) {
    if (e.kind() == Error::Kind::scene) throw;
    r.error = e.diagnostics().front().text();
  }
  return r;
}

}  // namespace

std::vector<Override> overrides_of(const ValidationCase& c, const std::string& solver,
                                   double spacing) {
  std::vector<Override> all{{"solver.name", solver},
                            {"particles.spacing", fmt::format("{}", spacing)}};
  for (const std::string& group : {std::string(), solver})
    for (const auto& [name, keys] : c.set)
      for (const auto& [key, value] : keys)
        if (name == group) all.emplace_back(key, in_metres(value, spacing));
  return all;
}

bool ValidationRun::passed() const {
  return error.empty() && std::all_of(results.begin(), results.end(),
                                      [](const ValidationResult& r) { return r.passed; });
}

std::vector<ValidationRun> validate(const ValidateOptions& options) {
  std::vector<Task> tasks;
  for (const ValidationCase& c : options.cases) {
    const bool shorter = options.short_form && c.short_form;
    const auto& solvers = shorter ? c.short_form->solvers : c.solvers;
    const auto& spacings = shorter ? c.short_form->spacings : c.spacings;
    for (const std::string& solver : solvers) {
      if (!options.solvers.empty() && std::find(options.solvers.begin(), options.solvers.end(),
                                                solver) == options.solvers.end())
        continue;
      if (options.spacing) tasks.push_back({&c, solver, *options.spacing});
      else
        for (const double spacing : spacings) tasks.push_back({&c, solver, spacing});
    }
  }
  std::vector<ValidationRun> runs(tasks.size());
  std::atomic<std::size_t> next = 0, done = 0;
  std::mutex told;
  std::exception_ptr failure;
  const auto work = [&] {
    for (std::size_t k; (k = next++) < tasks.size();) try {
        runs[k] = run_task(tasks[k], options);
        const std::lock_guard lock(told);
        if (options.after_run) options.after_run(runs[k], ++done, tasks.size());
      } catch (...) {
        const std::lock_guard lock(told);
        if (!failure) failure = std::current_exception();
        next = tasks.size();
      }
  };
  std::vector<std::jthread> others;
  for (int j = 1; j < options.jobs; ++j) others.emplace_back(work);
  work();
  others.clear();
  if (failure) std::rethrow_exception(failure);
  return runs;
}

double convergence_order(double error1, double spacing1, double error2, double spacing2) {
  return std::log(error1 / error2) / std::log(spacing1 / spacing2);
}

}  // namespace freshet
