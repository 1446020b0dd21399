// SPDX-License-Identifier: MIT
#pragma once
#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "freshet/scene.h"

namespace freshet {

/// A measure of a validation case and the bound of its result.
struct ValidationMeasure {
  /// table: a file of the run, observables.csv by default. "runs" is a table with one row for each
  /// run of a solver: the varied key and the results of the other measures. Its result belongs to
  /// the last run.
  std::string name, table;
  std::string beside;              ///< another table, interpolated to the times of the first
  std::string x, y, when;          ///< formulas in the table's columns; when: selects rows
  std::string since, since_when;   ///< table and formula; time counts from where it first holds
  std::optional<double> from, to;  ///< range of x
  std::string statistic;           ///< of y: "" for a curve, else mean, max, slope ...
  std::string expected;            ///< a formula in x, or a number; may be empty
  /// Reference data in place of `expected`: a file of the case and formulas in its columns.
  /// "finest": the curve of the finest run.
  std::string reference, rx, ry;
  std::string norm = "max";  ///< of a curve's differences: max, mean, rms
  /// scale: divisor of differences, by default the expected value. align: the value of y at which a
  /// curve and its reference are shifted to the same x
  std::optional<double> scale, align;
  std::optional<double> bound;        ///< of the difference, or of the value if none is expected
  std::optional<double> short_bound;  ///< bound of the short form, which runs coarser
  std::optional<double> order;        ///< minimum order between the two coarsest resolutions
  std::string reason;                 ///< for the bound or the order
};

/// An expected miss of some measures of some runs. Empty `solvers` or `resolutions` means all.
/// Without `measures` the run as a whole is expected to fail.
struct ValidationMiss {
  std::vector<std::string> solvers, measures;
  std::vector<double> resolutions;
  std::string reason;
};

/// A published case: a scene, its solvers and resolutions, and its measures.
struct ValidationCase {
  std::string name, title, text, source;
  std::filesystem::path folder, scene;
  std::vector<std::string> solvers;
  std::string varied = "particles.spacing";  ///< the scene key that takes the resolutions
  std::string unit = "m";                    ///< unit of the resolutions
  std::vector<double> resolutions;           ///< in descending order
  /// Runs per resolution, from starts that differ in the last digits. A result is their median.
  int repeats = 1;
  std::vector<ValidationMiss> misses;
  /// Overrides by solver; "" is for all solvers. A value "3 spacings" is multiplied by the run's
  /// spacing.
  std::vector<std::pair<std::string, std::vector<std::pair<std::string, std::string>>>> set;
  std::vector<ValidationMeasure> measures;
  struct Short {
    std::vector<std::string> solvers;
    std::vector<double> resolutions;
    std::optional<double> end;  ///< time.end of a shorter run [s]
    std::string cost;           ///< measured cost, as text
    int repeats = 1;
  };
  std::optional<Short> short_form;

  /// The last part of the varied key: spacing, step ...
  std::string varies() const { return varied.substr(varied.rfind('.') + 1); }
};

/// One measure of one run.
struct ValidationResult {
  std::string name;
  double value = 0;                ///< a difference, or the value itself
  std::optional<double> measured;  ///< the value of a statistic before the comparison
  std::optional<double> bound;
  std::vector<double> repeats;  ///< values of all repeats, ascending; empty for a single run
  bool passed = false;
  std::string reason;
  std::string plot;           ///< SVG; empty for an order
  bool at_least = false;      ///< true for an order: the bound is a minimum
  std::string expected_miss;  ///< reason of an expected miss; empty if a pass is expected
  bool as_expected() const { return passed == expected_miss.empty(); }
};

/// One run of a case.
struct ValidationRun {
  std::string case_name, solver;
  double resolution = 0;
  std::string varies = "spacing", unit = "m";  ///< name and unit of the resolution
  int repeat = 0;                              ///< 0 for the run without a changed start
  std::int64_t particles = 0, steps = 0;
  double seconds = 0;
  std::string commit;            ///< of the sources that computed the run
  std::string expected_failure;  ///< reason of an expected failure; empty if success is expected
  std::string error;             ///< message of a failed run; empty if it has results
  std::vector<ValidationResult> results;
  std::string picture;  ///< PNG of the final state
  bool passed() const;
  /// Whether each bound is met or missed as expected, and the run finished or failed as expected.
  bool as_expected() const;
};

/// The values of all repeats, "0.31 to 0.44"; empty for a single run.
std::string range_of(const ValidationResult& result);

/// "564 of 823 bounds are met (69 %). 373 of 373 runs meet or miss each bound as their case
/// expects."
std::string validation_summary(const std::vector<ValidationRun>& runs);

struct ValidateOptions {
  std::vector<ValidationCase> cases;
  std::vector<std::string> solvers;  ///< selects among the case's solvers; empty: all
  std::vector<Override> overrides;   ///< of each run's scene; they override the case's own
  std::vector<double> resolutions;   ///< replace the case's; empty: the case's
  std::optional<int> repeats;        ///< replaces the cases' repeats
  bool short_form = false;
  bool resume = false;           ///< reuse runs of the same scene in `output`
  bool run = true;               ///< false: measure the runs in `output` and run nothing
  int jobs = 1;                  ///< solvers of cases that run at the same time
  std::filesystem::path output;  ///< parent of the run folders
  std::function<void(const ValidationRun&)> before_run;
  /// Called when all resolutions of a solver have finished. The second run's results include the
  /// orders of convergence.
  std::function<void(const ValidationRun&, std::size_t done, std::size_t all)> after_run;
};

/// The overrides that a case, a solver and a resolution apply to the scene.
std::vector<Override> overrides_of(const ValidationCase&, const std::string& solver,
                                   double resolution);

/// The name of the result that holds the order of convergence of a measure.
std::string order_of(const ValidationMeasure&);

/// The cases below a folder, sorted by name. A case is a folder with a case.toml.
std::vector<ValidationCase> validation_cases(const std::filesystem::path& folder);
/// Reads a case.toml. Throws Error (kind scene) with FILE:LINE:COLUMN if it is invalid.
ValidationCase read_validation_case(const std::filesystem::path& folder);

/// Runs cases and measures them. A failed run is reported as a result; it throws no Error.
std::vector<ValidationRun> validate(const ValidateOptions& options);

/// The order of convergence of a measure between two resolutions, ln(e1/e2)/ln(dx1/dx2).
double convergence_order(double error1, double resolution1, double error2, double resolution2);

/// The results as JSON, as one HTML page with embedded plots and pictures, and as Markdown. The
/// Markdown has a table of solvers and cases, and a table of measures for each case.
std::string validation_json(const std::vector<ValidationRun>& runs);
std::string validation_html(const std::vector<ValidationCase>& cases,
                            const std::vector<ValidationRun>& runs);
std::string validation_markdown(const std::vector<ValidationCase>& cases,
                                const std::vector<ValidationRun>& runs);

}  // namespace freshet
