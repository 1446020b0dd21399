// SPDX-License-Identifier: MIT
#pragma once
#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "freshet/scene.h"

namespace freshet {

/// What a case measures, and what it may come to.
struct ValidationMeasure {
  /// table: a file of the run, observables.csv if not given. "runs": a row for each run of a
  /// solver, with what the runs differ by and what its other measures came to; the last run has the
  /// result.
  std::string name, table;
  std::string beside;              ///< another one, whose columns are taken at the same times
  std::string x, y, when;          ///< formulas in the table's columns; when: rows that count
  std::string since, since_when;   ///< time counts from where a table\'s formula first holds
  std::optional<double> from, to;  ///< of x
  std::string statistic;           ///< of y: "" for a curve, else mean, max, slope ...
  std::string expected;            ///< a formula in x, or a number; empty if there is none
  /// A file of the case instead, and formulas in its columns. "finest": the finest run's own curve.
  std::string reference, rx, ry;
  std::string norm = "max";            ///< of a curve's differences: max, mean, rms
  std::optional<double> scale, align;  ///< differences over it, else over the expected; y at x = 0
  std::optional<double> bound;         ///< of the difference; of the value itself if none expected
  std::optional<double> short_bound;   ///< of the short form: coarser, it guards what is reached
  std::optional<double> order;         ///< the least order between the two coarsest resolutions
  std::string reason;                  ///< for the bound, or the order
};

/// What is known to miss: these measures of these runs. A list that is empty names all; where no
/// measure is named, the run fails as a whole.
struct ValidationMiss {
  std::vector<std::string> solvers, measures;
  std::vector<double> resolutions;
  std::string reason;
};

/// A published case: a scene, the solvers and resolutions that it is run with, and what is
/// measured.
struct ValidationCase {
  std::string name, title, text, source;
  std::filesystem::path folder, scene;
  std::vector<std::string> solvers;
  std::string varied = "particles.spacing";  ///< the key of the scene that resolutions are of
  std::string unit = "m";                    ///< of the resolutions
  std::vector<double> resolutions;           ///< the greatest first
  std::vector<ValidationMiss> misses;
  /// Overrides by solver; "" is for all. A value of "3 spacings" is so many, where spacings vary.
  std::vector<std::pair<std::string, std::vector<std::pair<std::string, std::string>>>> set;
  std::vector<ValidationMeasure> measures;
  struct Short {
    std::vector<std::string> solvers;
    std::vector<double> resolutions;
    std::optional<double> end;  ///< [s], of a shorter run
    std::string cost;           ///< as measured
  };
  std::optional<Short> short_form;

  /// What the runs differ by, in a word: spacing, step ...
  std::string varies() const { return varied.substr(varied.rfind('.') + 1); }
};

/// One measure of one run.
struct ValidationResult {
  std::string name;
  double value = 0;                ///< a difference, or the value itself
  std::optional<double> measured;  ///< of a statistic: what was compared
  std::optional<double> bound;
  bool passed = false;
  std::string reason;
  std::string plot;           ///< SVG; empty for an order
  bool at_least = false;      ///< the bound is the least that the value may be: an order
  std::string expected_miss;  ///< why it is expected to miss its bound; empty: it is not
  bool as_expected() const { return passed == expected_miss.empty(); }
};

/// One run of a case.
struct ValidationRun {
  std::string case_name, solver;
  double resolution = 0;
  std::string varies = "spacing", unit = "m";  ///< what the resolution is
  std::int64_t particles = 0, steps = 0;
  double seconds = 0;
  std::string commit;            ///< of the sources that made it
  std::string expected_failure;  ///< why it is expected to fail as a whole; empty: it is not
  std::string error;             ///< why there is no result, if there is none
  std::vector<ValidationResult> results;
  std::string picture;  ///< PNG of the end
  bool passed() const;
  /// As it should be: each bound is met or missed, and the run came to its end, where that is
  /// expected.
  bool as_expected() const;
};

/// "564 of 823 bounds are met (69 %). 373 of 373 runs meet or miss each bound as their case
/// expects."
std::string validation_summary(const std::vector<ValidationRun>& runs);

struct ValidateOptions {
  std::vector<ValidationCase> cases;
  std::vector<std::string> solvers;  ///< of those that a case has; empty: all
  std::vector<Override> overrides;   ///< of the scene of each run, over those of its case
  std::vector<double> resolutions;   ///< instead of the case's; empty: those
  bool short_form = false;
  bool resume = false;           ///< runs of the same scene that `output` holds are not made again
  bool run = true;               ///< false: what `output` holds is measured, and nothing is run
  int jobs = 1;                  ///< solvers of cases at a time
  std::filesystem::path output;  ///< where the runs go, a folder each
  std::function<void(const ValidationRun&)> before_run;
  /// Once all resolutions of a solver are there; the orders of convergence are among the results of
  /// the second.
  std::function<void(const ValidationRun&, std::size_t done, std::size_t all)> after_run;
};

/// What a run of a case by a solver, at a resolution, changes in its scene.
std::vector<Override> overrides_of(const ValidationCase&, const std::string& solver,
                                   double resolution);

/// What the order of convergence of a measure is called among the results.
std::string order_of(const ValidationMeasure&);

/// The cases below a folder, by name: each a folder with a case.toml.
std::vector<ValidationCase> validation_cases(const std::filesystem::path& folder);
/// Throws Error (kind scene), with FILE:LINE:COLUMN, where a case.toml is wrong.
ValidationCase read_validation_case(const std::filesystem::path& folder);

/// Runs cases with the shipped engine and measures. A run that fails is a result, not an error.
std::vector<ValidationRun> validate(const ValidateOptions& options);

/// The order of convergence of a measure between two resolutions, ln(e1/e2)/ln(dx1/dx2).
double convergence_order(double error1, double resolution1, double error2, double resolution2);

/// All that the runs came to, as JSON; as one HTML page with its plots and pictures in it; and as
/// Markdown: a table of solvers and cases, and one of what was measured in each case.
std::string validation_json(const std::vector<ValidationRun>& runs);
std::string validation_html(const std::vector<ValidationCase>& cases,
                            const std::vector<ValidationRun>& runs);
std::string validation_markdown(const std::vector<ValidationCase>& cases,
                                const std::vector<ValidationRun>& runs);

}  // namespace freshet
