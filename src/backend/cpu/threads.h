// SPDX-License-Identifier: MIT
#pragma once
#include <algorithm>

namespace freshet {

/// Runs loops on a fixed number of threads. The result of a loop must not depend on their number.
class Threads {
 public:
  /// Throws Error (kind run) if the system does not start so many threads.
  explicit Threads(int count);
  int count() const { return count_; }
  /// The index of the calling thread within a loop, 0 to count - 1.
  static int current();

  /// Calls f(part) for part = 0 ... parts - 1, each on some thread. After an
  /// exception the parts that have not begun are skipped, and it is rethrown at the end.
  template <class F> void parts(int parts, const F& f) const {
    run(parts, &f, [](const void* context, int part) { (*static_cast<const F*>(context))(part); });
  }

  /// Calls f(begin, end) over [0, n) in blocks that do not depend on the number of threads.
  template <class F> void blocks(int n, const F& f) const {
    parts((n + block - 1) / block, [&](int b) { f(b * block, std::min(n, (b + 1) * block)); });
  }
  static constexpr int block = 2048;

 private:
  /// The loop is compiled once: an indirect call per part is cheap compared with the part.
  void run(int parts, const void* context, void (*part)(const void*, int)) const;
  void run_together(int parts, const void* context, void (*part)(const void*, int)) const;

  int count_;
};

}  // namespace freshet
