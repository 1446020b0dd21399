// SPDX-License-Identifier: MIT
#pragma once

namespace freshet {

/// The limits of a solve.
struct Iterations {
  double tolerance;  ///< maximum error of a converged solve
  int least, most;   ///< minimum and maximum number of iterations
};

/// The result of a solve. The error is a mean over the fluid: see SolveStatistics.
struct Solve {
  const char* name = "";
  int iterations = 0;
  double error = 0, tolerance = 0;
  bool converged() const { return error <= tolerance; }  // false for NaN
};

/// The results of the solves of a step.
struct Solves {
  Solve result[3];
  int count = 0;
  void add(const Solve& s) { result[count++] = s; }
  const Solve* begin() const { return result; }
  const Solve* end() const { return result + count; }
};

/// Repeats error = measure() and improve(error), from c.least to c.most iterations. It ends when
/// the error is within the tolerance or NaN.
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
