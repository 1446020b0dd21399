// SPDX-License-Identifier: MIT
#pragma once
#include <filesystem>

#include "run/table.h"
#include "validate/validate.h"

namespace freshet {

/// Points (x, y), the x ascending where a curve is compared.
struct Curve {
  std::vector<double> x, y;
};

/// y of a curve at x, linear between its points; no number beyond them.
double at(const Curve& curve, double x);

/// A number that says how y goes with x:
///
///   mean, min, max, last   of y
///   slope                  of the line of least squares
///   scatter                what that line leaves of y's variance, 1 - R^2
///   rate                   of y = a exp(rate x), by the line of least squares through ln y
///   decay                  the rate of the greatest y of each period, for what swings
///   period                 mean distance of the x at which y goes up through its mean
///   height                 mean of what is between the greatest and the least y of each period
/// Throws Error at `place`: of kind scene for another word, of kind run where there is nothing to
/// look at.
double statistic(const std::string& word, const Curve& curve, const std::string& place);

/// Differences between a curve and what is expected, at the places of `points`, one of the two,
/// where the other is known: the norm (max, mean, rms) of them over the scale, or without one over
/// |expected|.
double difference(const std::string& norm, const Curve& curve, const Curve& expected,
                  const Curve& points, std::optional<double> scale, const std::string& place);

/// Measures what a table tells, of a run's folder with those beside it; `finest` is the folder of
/// the finest run of its series.
ValidationResult measure(const ValidationCase& c, const ValidationMeasure& m, Table table,
                         const std::filesystem::path& run,
                         const std::filesystem::path& finest = {});

}  // namespace freshet
