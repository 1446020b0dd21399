// SPDX-License-Identifier: MIT
#pragma once
#include <omp.h>

#include <algorithm>
#include <exception>

namespace freshet {
inline namespace FRESHET_ISA {

/// Runs loops on a fixed number of threads. What a loop computes must not depend on their number.
class Threads {
 public:
  explicit Threads(int count) : count_(count) {}
  int count() const { return count_; }

  /// f(part) for part = 0 ... parts - 1, each on some thread.
  template <class F> void parts(int parts, const F& f) const {
    std::exception_ptr error;
#pragma omp parallel for num_threads(count_) schedule(dynamic, 1) if (parts > 1)
    for (int part = 0; part < parts; ++part) {
      try {
        f(part);
      } catch (...) {  // an exception must not leave the loop
#pragma omp critical(freshet_error)
        error = std::current_exception();
      }
    }
    if (error) std::rethrow_exception(error);
  }

  /// f(begin, end) over [0, n), in blocks that do not depend on the number of threads.
  template <class F> void blocks(int n, const F& f) const {
    parts((n + block - 1) / block, [&](int b) { f(b * block, std::min(n, (b + 1) * block)); });
  }
  static constexpr int block = 2048;

 private:
  int count_;
};

}  // namespace FRESHET_ISA
}  // namespace freshet
