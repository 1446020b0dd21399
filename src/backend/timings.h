// SPDX-License-Identifier: MIT
#pragma once
#include <chrono>
#include <string>
#include <vector>

#include "core/portable.h"
#include "freshet/report.h"

namespace freshet {
inline namespace FRESHET_ISA {

/// What each verb has cost, by name.
class Timings {
 public:
  const std::vector<VerbTiming>& list() const { return list_; }

  /// Adds the time until the end of the scope.
  class Scope {
   public:
    Scope(Timings& timings, const char* name, int targets)
        : timings_(timings), index_(timings.index(name)) {
      timings_.list_[index_].calls += 1;
      timings_.list_[index_].targets += targets;
    }
    Scope(const Scope&) = delete;
    ~Scope() {
      const std::chrono::duration<double> taken = Clock::now() - start_;
      timings_.list_[index_].seconds += taken.count();
    }

   private:
    using Clock = std::chrono::steady_clock;
    Timings& timings_;
    std::size_t index_;
    Clock::time_point start_ = Clock::now();
  };
  Scope time(const char* name, int targets) { return Scope(*this, name, targets); }

 private:
  std::size_t index(const char* name) {
    for (std::size_t k = 0; k < list_.size(); ++k)
      if (list_[k].name == name) return k;
    list_.push_back({name});
    return list_.size() - 1;
  }
  std::vector<VerbTiming> list_;
};

}  // namespace FRESHET_ISA
}  // namespace freshet
