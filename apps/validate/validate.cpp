// SPDX-License-Identifier: MIT
#include "validate/validate.h"

#include <fmt/format.h>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <latch>
#include <limits>
#include <mutex>
#include <nlohmann/json.hpp>
#include <optional>
#include <system_error>
#include <thread>

#include "core/input_file.h"
#include "core/text.h"
#include "freshet/run.h"
#include "scene/model/inputs.h"
#include "validate/measure.h"
#include "validate/repeats.h"

namespace freshet {
namespace {

namespace fs = std::filesystem;

/// A solver of a case, with all resolutions.
struct CaseSeries {
  const ValidationCase* the_case;
  std::string solver;
  std::vector<double> resolutions;
};

constexpr const char* over_runs = "runs";  ///< the table that a measure over all runs looks at

/// "3 spacings" as a length [m]; anything else as it is.
std::string in_metres(const std::string& value, double spacing) {
  const auto end = value.rfind(" spacings");
  const auto count = end == std::string::npos ? std::nullopt : number_in(value.substr(0, end));
  return count ? fmt::format("{}", *count * spacing) : value;
}

/// The bytes of a file; none if it is missing.
std::string bytes_of(const fs::path& file) {
  constexpr InputFile any{.may_be_empty = true};
  return fs::exists(file) ? read_input(file, any) : "";
}

bool is_one_of(const std::vector<std::string>& all, const std::string& name) {
  return all.empty() || std::find(all.begin(), all.end(), name) != all.end();
}

/// Why a run is expected to miss a measure; "": to fail as a whole.
std::string expected_miss(const ValidationCase& c, const ValidationRun& r,
                          const std::string& measure) {
  for (const ValidationMiss& miss : c.misses) {
    const bool whole = miss.measures.empty();
    const bool near = std::any_of(miss.resolutions.begin(), miss.resolutions.end(), [&](double x) {
      return std::abs(x - r.resolution) < 1e-6 * r.resolution;
    });
    if (is_one_of(miss.solvers, r.solver) && (miss.resolutions.empty() || near) &&
        (whole ? measure.empty() : !measure.empty() && is_one_of(miss.measures, measure)))
      return miss.reason;
  }
  return "";
}

/// Whether the folder holds a run of the very scene.
bool holds(const fs::path& folder, const Scene& scene) {
  const Inputs inputs = inputs_of(scene);
  return bytes_of(folder / "scene.toml") == inputs.source &&
         std::all_of(inputs.files.begin(), inputs.files.end(), [&](const auto& file) {
           return bytes_of(folder / file.first) == file.second;
         });
}

nlohmann::json json_of(const fs::path& file) {
  return nlohmann::json::parse(bytes_of(file), nullptr, false);
}

/// Runs, unless the folder holds the run; goes on with one that was stopped.
void simulate(const Scene& scene, const RunOptions& run, bool resume) {
  if (resume && holds(run.output, scene)) {
    if (fs::exists(run.output / "report.json")) return;
    try {
      freshet::resume({run.output, {}, run.command, run.execution, {}, {}, {}});
      return;
    } catch (const Error&) {  // it left nothing to go on from
    }
  }
  freshet::run(scene, run);
}

bool is_under_way(const fs::path& folder) {
  return !fs::exists(folder / "report.json") &&
         json_of(folder / "manifest.json").value("state", "") != "failed";
}

/// What a run tells of itself.
void tell_costs(ValidationRun& r, const fs::path& folder) {
  const auto report = json_of(folder / "report.json"), manifest = json_of(folder / "manifest.json");
  r.particles = report["statistics"].value("particles", std::int64_t(0));
  r.steps = report.value("steps", std::int64_t(0));
  r.seconds = report.value("seconds", 0.0);
  r.commit = manifest.value("commit", "");
  r.picture = bytes_of(folder / "result.png");
}

fs::path folder_of(const ValidationRun& r, const ValidateOptions& options) {
  return options.output / fmt::format("{}_{}_{:g}{}", r.case_name, r.solver, r.resolution,
                                      r.repeat ? fmt::format("_{}", r.repeat) : "");
}

/// What the short form of a case is, where it is asked for.
std::optional<ValidationCase::Short> short_form_of(const ValidationCase& c,
                                                   const ValidateOptions& options) {
  return options.short_form ? c.short_form : std::nullopt;
}

/// None, if it may not be run and has not been.
std::optional<ValidationRun> run_of(const CaseSeries& s, double resolution, int repeat,
                                    const ValidateOptions& options) {
  const ValidationCase& c = *s.the_case;
  ValidationRun r;
  r.case_name = c.name;
  r.solver = s.solver;
  r.resolution = resolution;
  r.varies = c.varies();
  r.unit = c.unit;
  r.repeat = repeat;
  r.expected_failure = expected_miss(c, r, "");
  if (options.run && options.before_run) options.before_run(r);
  try {
    auto overrides = overrides_of(c, s.solver, resolution);
    if (const auto shorter = short_form_of(c, options); shorter && shorter->end)
      overrides.emplace_back("time.end", fmt::format("{}", *shorter->end));
    overrides.insert(overrides.end(), options.overrides.begin(), options.overrides.end());
    Scene scene = load_scene(c.scene, overrides);
    if (const auto start = changed_start(scene, repeat); !start.empty()) {
      overrides.insert(overrides.end(), start.begin(), start.end());
      scene = load_scene(c.scene, overrides);
    }
    RunOptions run;
    run.output = folder_of(r, options);
    run.overwrite = true;
    run.scene_name = c.name;
    run.command = {"freshet", "validate", c.name};
    run.execution.threads = options.jobs > 1 ? 1 : 0;
    if (options.run) simulate(scene, run, options.resume);
    else if (!holds(run.output, scene) || is_under_way(run.output)) return {};
    if (fs::exists(run.output / "report.json")) tell_costs(r, run.output);
    else r.error = "the run failed";
  } catch (const Error& e) {
    if (e.kind() == Error::Kind::scene) throw;
    r.error = e.diagnostics().front().text();
  }
  return r;
}

/// A run that has left nothing to measure misses the bound, if there is one.
ValidationResult measure_or_miss(const ValidationCase& c, const ValidationMeasure& m,
                                 const fs::path& folder, const fs::path& finest,
                                 const Table* runs = nullptr) {
  try {
    return measure(c, m, runs ? *runs : read_table(folder / m.table), folder, finest);
  } catch (const Error& e) {
    if (e.kind() == Error::Kind::scene) throw;
    ValidationResult r;
    r.name = m.name;
    r.value = std::numeric_limits<double>::quiet_NaN();
    r.bound = m.bound;
    r.passed = !m.bound;
    r.reason = e.diagnostics().front().message;
    return r;
  }
}

/// Measures a run; the last of its series, whose table of `runs` is given, with what is over all.
void measure_run(const ValidationCase& c, ValidationRun& r, const ValidateOptions& options,
                 const fs::path& finest, const Table* runs = nullptr) {
  const fs::path folder = folder_of(r, options);
  for (ValidationMeasure m : c.measures) {
    if ((m.reference == "finest" && folder == finest) || (m.table == over_runs) != bool(runs))
      continue;
    const bool guards = options.short_form && m.short_bound;
    if (guards) m.bound = m.short_bound;
    r.results.push_back(measure_or_miss(c, m, folder, finest, runs));
    if (m.bound && !guards) r.results.back().expected_miss = expected_miss(c, r, m.name);
  }
}

const ValidationResult* find(const ValidationRun& r, const std::string& name) {
  const auto found = std::find_if(r.results.begin(), r.results.end(),
                                  [&](const ValidationResult& v) { return v.name == name; });
  return found == r.results.end() ? nullptr : &*found;
}

/// The orders that are asked for, between the two coarsest runs.
void add_orders(const ValidationCase& c, const ValidationRun& coarse, ValidationRun& fine) {
  for (const ValidationMeasure& m : c.measures) {
    const ValidationResult *a = find(coarse, m.name), *b = find(fine, m.name);
    if (!m.order || !a || !b) continue;
    ValidationResult order;
    order.name = order_of(m);
    order.value = convergence_order(a->value, coarse.resolution, b->value, fine.resolution);
    order.bound = m.order;
    order.at_least = true;
    order.passed = order.value >= *m.order;
    order.reason = m.reason;
    order.expected_miss = expected_miss(c, fine, order.name);
    fine.results.push_back(order);
  }
}

/// A row for each run: what it was run with, and what its measures came to.
Table table_of(const ValidationCase& c, const std::vector<ValidationRun>& runs) {
  Table table;
  table.rows = runs.size();
  table.columns.push_back({c.varies(), c.unit, {}, {}});
  for (const ValidationRun& r : runs) table.columns[0].numbers.push_back(r.resolution);
  for (const ValidationMeasure& m : c.measures) {
    if (m.table == over_runs) continue;
    Column column{m.name, "", {}, {}};
    for (const ValidationRun& r : runs) {
      const ValidationResult* v = find(r, m.name);
      column.numbers.push_back(v ? v->measured.value_or(v->value)
                                 : std::numeric_limits<double>::quiet_NaN());
    }
    table.columns.push_back(std::move(column));
  }
  return table;
}

/// The runs of one repeat, with what is measured of each alone.
std::vector<ValidationRun> run_repeat(const CaseSeries& s, int repeat,
                                      const ValidateOptions& options) {
  std::vector<ValidationRun> runs;
  for (const double resolution : s.resolutions)
    if (auto r = run_of(s, resolution, repeat, options)) runs.push_back(std::move(*r));
  if (runs.empty()) return runs;
  const fs::path finest = folder_of(runs.back(), options);
  for (ValidationRun& r : runs)
    if (r.error.empty()) measure_run(*s.the_case, r, options, finest);
  return runs;
}

std::vector<ValidationRun> run_series(const CaseSeries& s, const ValidateOptions& options) {
  std::vector<std::vector<ValidationRun>> repeats;  // by resolution
  const auto shorter = short_form_of(*s.the_case, options);
  const int usual = shorter ? shorter->repeats : s.the_case->repeats;
  for (int k = 0; k < options.repeats.value_or(usual); ++k) {
    auto runs = run_repeat(s, k, options);
    repeats.resize(std::max(repeats.size(), runs.size()));
    for (std::size_t r = 0; r < runs.size(); ++r) repeats[r].push_back(std::move(runs[r]));
  }
  std::vector<ValidationRun> runs;
  for (auto& of_resolution : repeats) runs.push_back(median_of(std::move(of_resolution)));
  if (runs.size() > 1) {
    add_orders(*s.the_case, runs[0], runs[1]);
    const Table all = table_of(*s.the_case, runs);
    measure_run(*s.the_case, runs.back(), options, folder_of(runs.back(), options), &all);
  }
  return runs;
}

std::vector<CaseSeries> all_series(const ValidateOptions& options) {
  std::vector<CaseSeries> all;
  for (const ValidationCase& c : options.cases) {
    const auto shorter = short_form_of(c, options);
    const auto& solvers = shorter ? shorter->solvers : c.solvers;
    auto resolutions = shorter ? shorter->resolutions : c.resolutions;
    if (!options.resolutions.empty()) resolutions = options.resolutions;
    std::sort(resolutions.begin(), resolutions.end(), std::greater<>());
    for (const std::string& solver : solvers)
      if (is_one_of(options.solvers, solver)) all.push_back({&c, solver, resolutions});
  }
  return all;
}

}  // namespace

std::vector<Override> overrides_of(const ValidationCase& c, const std::string& solver,
                                   double resolution) {
  const bool spacings = c.varied == "particles.spacing";
  std::vector<Override> all{{"solver.name", solver}, {c.varied, fmt::format("{}", resolution)}};
  for (const std::string& group : {std::string(), solver})
    for (const auto& [name, keys] : c.set)
      for (const auto& [key, value] : keys)
        if (name == group) all.emplace_back(key, spacings ? in_metres(value, resolution) : value);
  return all;
}

bool ValidationRun::passed() const {
  return error.empty() && std::all_of(results.begin(), results.end(),
                                      [](const ValidationResult& r) { return r.passed; });
}
bool ValidationRun::as_expected() const {
  if (!error.empty() || !expected_failure.empty()) return passed() == expected_failure.empty();
  return std::all_of(results.begin(), results.end(),
                     [](const ValidationResult& r) { return r.as_expected(); });
}

std::string order_of(const ValidationMeasure& m) { return m.name + ": order of convergence"; }

std::vector<ValidationRun> validate(const ValidateOptions& options) {
  const std::vector<CaseSeries> series = all_series(options);
  std::vector<std::vector<ValidationRun>> runs(series.size());
  std::size_t all = 0, done = 0;
  for (const CaseSeries& s : series) all += s.resolutions.size();
  ValidateOptions one_at_a_time = options;
  std::mutex telling;
  if (options.before_run)
    one_at_a_time.before_run = [&](const ValidationRun& r) {
      const std::lock_guard lock(telling);
      options.before_run(r);
    };
  std::atomic<std::size_t> next = 0;
  std::exception_ptr failure;
  std::latch all_started(1);
  const auto work = [&] {
    all_started.wait();
    for (std::size_t k; (k = next++) < series.size();) try {
        runs[k] = run_series(series[k], one_at_a_time);
        const std::lock_guard lock(telling);
        for (const ValidationRun& r : runs[k])
          if (++done; options.after_run) options.after_run(r, done, all);
      } catch (...) {
        const std::lock_guard lock(telling);
        if (!failure) failure = std::current_exception();
        next = series.size();
      }
  };
  std::vector<std::jthread> others;
  try {
    for (int j = 1; j < options.jobs; ++j) others.emplace_back(work);
  } catch (const std::system_error& e) {
    next = series.size();
    all_started.count_down();
    throw Error(Error::Kind::run, "option jobs " + std::to_string(options.jobs),
                "the system does not start so many threads (" + e.code().message() +
                    "); run fewer cases at a time, or raise the limit on processes (ulimit -u)");
  }
  all_started.count_down();
  work();
  others.clear();
  if (failure) std::rethrow_exception(failure);
  std::vector<ValidationRun> flat;
  for (auto& of_series : runs)
    std::move(of_series.begin(), of_series.end(), std::back_inserter(flat));
  return flat;
}

double convergence_order(double error1, double resolution1, double error2, double resolution2) {
  return std::log(error1 / error2) / std::log(resolution1 / resolution2);
}

}  // namespace freshet
