// SPDX-License-Identifier: MIT
#pragma once
#include <chrono>
#include <vector>

#include "freshet/report.h"

namespace freshet {

/// The accumulated cost of each verb, by name.
class Timings {
 public:
  const std::vector<VerbTiming>& list() const { return list_; }

  /// Measures the time until the end of the scope.
  class Scope {
   public:
    Scope(Timings& timings, const char* name, int targets);
    Scope(const Scope&) = delete;
    ~Scope();

   private:
    using Clock = std::chrono::steady_clock;
    Timings& timings_;
    std::size_t index_;
    Clock::time_point start_ = Clock::now();
  };
  Scope time(const char* name, int targets) { return Scope(*this, name, targets); }

 private:
  std::vector<VerbTiming> list_;
};

}  // namespace freshet
