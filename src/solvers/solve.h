// SPDX-License-Identifier: MIT
#pragma once

namespace freshet {

/// How far a solve goes.
struct Iterations {
  double tolerance;  ///< of the error
  int least, most;
};

/// What a solve came to. The error is a mean over the fluid: see SolveStatistics.
struct Solve {
  const char* name;
  int iterations;
  double error, tolerance;
  bool converged() const { return error <= tolerance; }  // no number is none
};

/// error = measure(), then improve(error), until the error is within the tolerance, or no number.
template <class Measure, class Improve>
Solve solve(const char* name, const Iterations& c, const Measure& measure, const Improve& improve) {
  for (int n = 1;; ++n) {
    const double error = measure();
    const bool good = n >= c.least && !(error > c.tolerance);
    if (good || n >= c.most) return {name, n, error, c.tolerance};
    improve(error);
  }
}

}  // namespace freshet
