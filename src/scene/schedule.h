// SPDX-License-Identifier: MIT
#pragma once
#include <algorithm>

#include "freshet/scene.h"

namespace freshet {

/// After which steps, counted from 0, something is written. It never changes a step.
class Schedule {
 public:
  explicit Schedule(const Scene& scene)
      : last_(scene.steps() - 1),
        frame_every_(
            scene.output.frame_every_steps.value_or(std::max<std::int64_t>(1, last_ / 10))),
        observe_every_(
            scene.output.observables_every_steps.value_or(std::max<std::int64_t>(1, last_ / 100))) {
  }

  bool frame_after(std::int64_t step) const { return step % frame_every_ == 0 || step == last_; }
  bool observe_after(std::int64_t step) const {
    return step % observe_every_ == 0 || step == last_;
  }
  std::int64_t frames() const { return last_ / frame_every_ + 1 + (last_ % frame_every_ != 0); }

 private:
  std::int64_t last_, frame_every_, observe_every_;
};

}  // namespace freshet
