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
  std::string name, table;             ///< table: a file of the run, observables.csv if not given
  std::string beside;                  ///< another one, whose columns are taken at the same times
  std::string x, y, when;              ///< formulas in the table's columns; when: rows that count
  std::optional<double> from, to;      ///< of x
  std::string statistic;               ///< of y: "" for a curve, else mean, max, slope ...
  std::string expected;                ///< a formula in x, or a number; empty if there is none
  std::string reference, rx, ry;       ///< a file of the case instead, and formulas in its columns
  std::string norm = "max";            ///< of a curve's differences: max, mean, rms
  std::optional<double> scale, align;  ///< differences over it, else over the expected; y at x = 0
  std::optional<double> bound;         ///< of the difference; of the value itself if none expected
  std::optional<double> short_bound;   ///< of the short form: coarser, it guards what is reached
  std::string reason;                  ///< for the bound
};

/// A published case: a scene, the solvers and spacings that it is run with, and what is measured.
struct ValidationCase {
  std::string name, title, text, source;
  std::filesystem::path folder, scene;
  std::vector<std::string> solvers;
  std::vector<double> spacings;  ///< particles.spacing [m], the coarsest first
  std::vector<std::pair<std::string, std::string>> expected_failures;  ///< solver, reason
  /// Overrides by solver; "" is for all. A value of "3 spacings" is so many.
  std::vector<std::pair<std::string, std::vector<std::pair<std::string, std::string>>>> set;
  std::vector<ValidationMeasure> measures;
  struct Short {
    std::vector<std::string> solvers;
    std::vector<double> spacings;
    std::string cost;  ///< as measured
  };
  std::optional<Short> short_form;
};

/// One measure of one run.
struct ValidationResult {
  std::string name;
  double value = 0;                ///< a difference, or the value itself
  std::optional<double> measured;  ///< of a statistic: what was compared
  std::optional<double> bound;
  bool passed = false;
  std::string reason;
  std::string plot;  ///< SVG; empty for a statistic
};

/// One run of a case.
struct ValidationRun {
  std::string case_name, solver;
  double spacing = 0;
  std::int64_t particles = 0, steps = 0;
  double seconds = 0;
  std::string expected_failure;  ///< why it is expected to miss its bounds; empty: it is not
  std::string error;             ///< why there is no result, if there is none
  std::vector<ValidationResult> results;
  std::string picture;  ///< PNG of the end
  bool passed() const;
  /// As it should be: passed, or failed where that is expected.
  bool as_expected() const { return passed() == expected_failure.empty(); }
};

struct ValidateOptions {
  std::vector<ValidationCase> cases;
  std::vector<std::string> solvers;  ///< of those that a case has; empty: all
  std::optional<double> spacing;     ///< instead of the case's
  bool short_form = false;
  int jobs = 1;
  std::filesystem::path output;  ///< where the runs go, a folder each
  std::function<void(const ValidationRun&, std::size_t done, std::size_t all)> after_run;
};

/// What a run of a case by a solver, at a spacing [m], changes in its scene.
std::vector<Override> overrides_of(const ValidationCase&, const std::string& solver,
                                   double spacing);

/// The cases below a folder, by name: each a folder with a case.toml.
std::vector<ValidationCase> validation_cases(const std::filesystem::path& folder);
/// Throws Error (kind scene), with FILE:LINE:COLUMN, where a case.toml is wrong.
ValidationCase read_validation_case(const std::filesystem::path& folder);

/// Runs cases with the shipped engine and measures. A run that fails is a result, not an error.
std::vector<ValidationRun> validate(const ValidateOptions& options);

/// The order of convergence of a measure between two spacings, ln(e1/e2)/ln(dx1/dx2).
double convergence_order(double error1, double spacing1, double error2, double spacing2);

/// All that a run came to, as JSON; as one HTML page with its plots and pictures in it; and as a
/// table of solvers and cases in Markdown.
std::string validation_json(const std::vector<ValidationRun>& runs);
std::string validation_html(const std::vector<ValidationCase>& cases,
                            const std::vector<ValidationRun>& runs);
std::string validation_markdown(const std::vector<ValidationCase>& cases,
                                const std::vector<ValidationRun>& runs);

}  // namespace freshet
