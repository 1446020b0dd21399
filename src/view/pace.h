// SPDX-License-Identifier: MIT
#pragma once
#include <algorithm>
#include <chrono>

namespace freshet::view {

/// Holds a simulation back to so many simulated seconds per second of wall time.
class Pace {
 public:
  using Clock = std::chrono::steady_clock;

  double limit() const { return limit_; }
  /// 0: as fast as possible.
  void set_limit(double limit) {
    limit_ = std::max(limit, 0.0);
    started_ = false;
  }
  /// Counts from the next call of wait() on.
  void restart() { started_ = false; }
  /// How long a step that ends at `time` [s] should wait. A simulation that is slower than its pace
  /// does not catch up later.
  Clock::duration wait(double time, Clock::time_point now) {
    if (limit_ == 0) return Clock::duration::zero();
    if (!started_ || time < time_) begin(time, now);
    const auto due =
        wall_ + std::chrono::duration_cast<Clock::duration>(
                    std::chrono::duration<double>(std::min((time - time_) / limit_, 1e6)));
    if (now - due > std::chrono::milliseconds(100)) begin(time, now);
    return std::max(due - now, Clock::duration::zero());
  }

 private:
  void begin(double time, Clock::time_point now) {
    started_ = true;
    time_ = time;
    wall_ = now;
  }

  double limit_ = 1, time_ = 0;
  bool started_ = false;
  Clock::time_point wall_{};
};

}  // namespace freshet::view
