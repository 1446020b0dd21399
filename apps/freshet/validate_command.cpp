// SPDX-License-Identifier: MIT
#include "validate/validate.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <set>

#include "command.h"
#include "freshet/simulation.h"
#include "freshet/suggest.h"
#include "print.h"
#include "whole_file.h"

namespace freshet::cli {
namespace {

namespace fs = std::filesystem;

struct ValidateArguments {
  KeyArguments keys;
  std::vector<std::string> cases, solvers;
  std::vector<double> resolutions;
  std::string report, output = "runs/validation";
  int jobs = 1, repeats = 0;
  bool all = false, short_form = false, resume = false, measure_only = false, json = false;
};

std::vector<ValidationCase> cases_that_come_along() {
  for (const fs::path& folder : folders_that_come_along("validation"))
    if (auto cases = validation_cases(folder); !cases.empty()) return cases;
  throw Error(Error::Kind::scene, "",
              "no validation cases come along; is Freshet installed whole?");
}

}  // namespace

std::vector<std::string> case_names() {
  std::vector<std::string> names;
  for (const ValidationCase& c : cases_that_come_along()) names.push_back(c.name);
  return names;
}

namespace {

/// Those that are asked for: by name, or a folder with a case.toml.
std::vector<ValidationCase> chosen(const ValidateArguments& a) {
  if (a.all) return cases_that_come_along();
  std::vector<ValidationCase> found;
  for (const std::string& name : a.cases) {
    std::error_code ec;
    if (fs::is_regular_file(fs::path(name) / "case.toml", ec)) {
      found.push_back(read_validation_case(fs::weakly_canonical(name)));
      continue;
    }
    std::vector<std::string> names;
    for (ValidationCase& c : cases_that_come_along()) {
      names.push_back(c.name);
      if (c.name == name) found.push_back(std::move(c));
    }
    if (std::find(names.begin(), names.end(), name) != names.end()) continue;
    const std::string guess =
        nearest(name, std::set<std::string, std::less<>>(names.begin(), names.end()));
    throw Error(Error::Kind::scene, name,
                guess.empty()
                    ? fmt::format("no case of that name; there are {}", fmt::join(names, ", "))
                    : fmt::format("no case of that name; did you mean {}?", guess));
  }
  return found;
}

void list() {
  for (const ValidationCase& c : cases_that_come_along())
    print_out("{:<24} {}{}\n", c.name, printable(c.title),
              c.short_form ? fmt::format(" (short: {})", c.short_form->cost) : "");
}

std::string name_of(const ValidationRun& r) {
  return fmt::format("{} {} {:g} {}{}", r.case_name, r.solver, r.resolution, r.unit,
                     r.repeat ? fmt::format(", repeat {}", r.repeat) : "");
}

/// A line for each run, and one for each measure.
void tell(const ValidationRun& r, std::size_t done, std::size_t all) {
  const char* word = r.as_expected()    ? r.passed() ? "passed" : "misses, as expected"
                     : !r.error.empty() ? "FAILED"
                     : r.passed()       ? "passes, though it was expected to fail"
                                        : "MISSED";
  print_error("[{}/{}] {}: {} ({} particles, {:.1f} s)\n", done, all, name_of(r), word, r.particles,
              r.seconds);
  if (!r.error.empty()) print_error("    {}\n", r.error);
  for (const ValidationResult& v : r.results)
    print_error(
        "    {:<36} {:.4g}{}{}{}\n", v.name, v.value,
        v.repeats.empty() ? "" : fmt::format(", median of {}", range_of(v)),
        v.bound ? fmt::format(" ({} {:g})", v.at_least ? "at least" : "bound", *v.bound) : "",
        v.as_expected() ? v.passed ? "" : " missed, as expected"
        : v.passed      ? " met, though it was expected to be missed"
                        : " missed");
}

int validate_with(const ValidateArguments& a) {
  if (a.jobs > thread_limit())
    throw Error(
        Error::Kind::scene, fmt::format("--jobs {}", a.jobs),
        fmt::format("at most {} on this machine; run fewer cases at a time", thread_limit()));
  ValidateOptions options;
  options.cases = chosen(a);
  options.solvers = a.solvers;
  options.resolutions = a.resolutions;
  options.overrides = a.keys.overrides();
  options.resume = a.resume;
  options.run = !a.measure_only;
  options.short_form = a.short_form;
  options.jobs = a.jobs;
  if (a.repeats > 0) options.repeats = a.repeats;
  options.output = a.output;
  options.before_run = [](const ValidationRun& r) { print_error("running {} ...\n", name_of(r)); };
  options.after_run = tell;
  const auto runs = validate(options);
  if (runs.empty())
    throw Error(Error::Kind::scene, a.measure_only ? "--measure-only" : "--solver",
                a.measure_only ? "--output holds no run of these cases; leave --measure-only out"
                               : "none of the cases is run with it; see freshet validate for the "
                                 "cases, and their case.toml for the solvers");
  if (!a.report.empty()) {
    write_whole(fs::path(a.report) / "index.html", validation_html(options.cases, runs));
    write_whole(fs::path(a.report) / "validation.json", validation_json(runs));
    write_whole(fs::path(a.report) / "validation.md", validation_markdown(options.cases, runs));
    print_error("wrote {}\n", printable((fs::path(a.report) / "index.html").string()));
  }
  if (a.json) put(validation_json(runs));
  const auto bad =
      std::count_if(runs.begin(), runs.end(), [](auto& r) { return !r.as_expected(); });
  print_error("{}\n", validation_summary(runs));
  return bad ? failed : done;
}

}  // namespace

void add_validate(Program& program) {
  const auto a = std::make_shared<ValidateArguments>();
  const Command command =
      program.add("validate", "Compare simulations with experiments and closed forms");
  command.option("CASE", a->cases, "cases to run (none: list them), or folders of them");
  command.flag("--all", a->all, "all cases");
  command.option("--solver", a->solvers, "these solvers only")
      .value("SOLVER")
      .repeatable()
      .one_of(solver_names());
  command
      .option("--resolution", a->resolutions,
              "other values of particles.spacing [m], or of the key that the case varies")
      .repeatable()
      .positive();
  command
      .option("--repeats", a->repeats,
              "runs of each, from starts that differ in the last digits; results are medians")
      .at_least(1);
  a->keys.add_to(command, "a key of all scenes");
  command.flag("--short", a->short_form, "coarser, with fewer solvers: minutes for all");
  command.flag("--resume", a->resume,
               "keep the finished runs of the same scenes in --output, and resume stopped ones");
  command.flag("--measure-only", a->measure_only, "measure the runs in --output, and run nothing");
  command.option("--jobs", a->jobs, "runs at a time, one thread each (default: one, all threads)")
      .at_least(1);
  command.option("--output", a->output, "the folder of the runs (default: runs/validation)")
      .value("FOLDER");
  command.option("--report", a->report, "folder for index.html, validation.json and validation.md")
      .value("FOLDER");
  command.flag("--json", a->json, "print the results as JSON");
  command.footer(
      "The bounds stay those of the cases, whatever --set and --unset change.\n"
      "The exit code is 1 where a bound is missed, or met, against the expectation of the case.\n"
      "Examples:\n  freshet validate\n"
      "  freshet validate dam_break_front --solver dfsph\n"
      "  freshet validate --all --short --jobs 2 --report validation_report\n"
      "  freshet validate --all --resume --report validation_report");
  command.action([a]() -> int {
    if (!a->cases.empty() || a->all) return validate_with(*a);
    list();
    return done;
  });
}

}  // namespace freshet::cli
