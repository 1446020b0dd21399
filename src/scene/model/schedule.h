// SPDX-License-Identifier: MIT
#pragma once
#include <algorithm>
#include <cmath>
#include <optional>

#include "freshet/scene.h"

namespace freshet {

/// A completed step: its number, counted from 0, and the time before and after it [s].
struct StepTaken {
  std::int64_t step;
  double before, after;
  bool last;  ///< the last step of the run
};

/// When something is written: after step 0, after the last step, and at an interval of steps or
/// seconds in between. With seconds it is written after the first step at or after each such time.
class Every {
 public:
  Every(std::optional<std::int64_t> steps, std::optional<double> seconds) {
    if (seconds) seconds_ = *seconds;
    else steps_ = steps.value_or(1);
  }
  bool due(const StepTaken& s) const {
    if (s.step == 0 || s.last) return true;
    return steps_ > 0 ? s.step % steps_ == 0 : times_by(s.after) > times_by(s.before);
  }
  /// Whether the interval alone makes the step due. The first and the last step are no exceptions.
  bool due_within(const StepTaken& s) const {
    return steps_ > 0 ? (s.step + 1) % steps_ == 0 : times_by(s.after) > times_by(s.before);
  }
  /// The number of times in a run of this many steps. Adaptive steps have step = 0; the result is
  /// then the maximum.
  std::int64_t times(std::int64_t steps, double end, double step) const {
    const std::int64_t last = steps - 1;
    if (steps_ > 0) return last / steps_ + 1 + (last % steps_ != 0);
    if (step == 0) return whole(times_by(end)) + 1 + (times_by(end) * seconds_ < end * (1 - 1e-9));
    const std::int64_t due = whole(times_by(double(steps) * step));
    if (due == 0) return last == 0 ? 1 : 2;
    return due + (step_of(1, step) > 0) + (step_of(due, step) < last);
  }

 private:
  /// The number of times k·seconds, k > 0, up to t, with a tolerance for rounding.
  double times_by(double t) const { return std::floor(t / seconds_ + 1e-9); }
  static std::int64_t whole(double count) { return std::int64_t(std::min(count, 9e15)); }
  /// The number of the step, each `step` seconds long, after which the k-th time is due.
  std::int64_t step_of(std::int64_t k, double step) const {
    std::int64_t n = std::llround(double(k) * seconds_ / step);
    while (n > 1 && times_by(double(n - 1) * step) >= double(k)) --n;
    while (times_by(double(n) * step) < double(k)) ++n;
    return n - 1;
  }

  std::int64_t steps_ = 0;
  double seconds_ = 0;
};

/// The steps after which something is written. A schedule never changes the length of a step.
class Schedule {
 public:
  explicit Schedule(const Scene& s)
      : frame_(every(s, s.output.frame_every_steps, s.output.frame_every, 10)),
        observe_(every(s, s.output.observables_every_steps, s.output.observables_every, 100)),
        data_(data_of(s)),
        probes_(probes_of(s)),
        checkpoint_(
            s.output.checkpoint_every_steps || s.output.checkpoint_every
                ? std::optional<Every>({s.output.checkpoint_every_steps, s.output.checkpoint_every})
                : std::nullopt),
        frames_(times(s, frame_)),
        data_frames_(s.output.data.empty() ? 0 : times(s, data_)) {}

  bool frame_after(const StepTaken& s) const { return frame_.due(s); }
  bool data_after(const StepTaken& s) const { return data_frames_ > 0 && data_.due(s); }
  /// Whether the k-th probe measures.
  bool probe_after(std::size_t k, const StepTaken& s) const { return probes_[k].due(s); }
  bool observe_after(const StepTaken& s) const { return observe_.due(s); }
  /// Whether the interval of the scene makes a checkpoint due. Without one, the clock decides.
  bool checkpoint_after(const StepTaken& s) const {
    return checkpoint_ && checkpoint_->due_within(s);
  }
  bool checkpoints_by_clock() const { return !checkpoint_; }
  /// The number of frames of a run; the maximum for adaptive steps.
  std::int64_t frames() const { return frames_; }
  /// The number of data files of each format; the maximum for adaptive steps.
  std::int64_t data_frames() const { return data_frames_; }

 private:
  static Every every(const Scene& s, std::optional<std::int64_t> steps,
                     std::optional<double> seconds, std::int64_t parts) {
    if (!steps && !seconds && s.time.adaptive) seconds = s.time.end / double(parts);
    if (!steps && !seconds) steps = std::max<std::int64_t>(1, (s.steps() - 1) / parts);
    return {steps, seconds};
  }
  static Every data_of(const Scene& s) {
    const auto& o = s.output;
    if (o.data_every_steps || o.data_every) return every(s, o.data_every_steps, o.data_every, 10);
    return every(s, o.frame_every_steps, o.frame_every, 10);
  }
  static std::vector<Every> probes_of(const Scene& s) {
    std::vector<Every> all;
    for (const Scene::Probe& p : s.probe)
      all.push_back(
          p.every ? Every({}, p.every)
                  : every(s, s.output.observables_every_steps, s.output.observables_every, 100));
    return all;
  }
  static std::int64_t times(const Scene& s, const Every& e) {
    return e.times(s.steps(), s.time.end, s.time.adaptive ? 0 : s.time.step);
  }

  Every frame_, observe_, data_;
  std::vector<Every> probes_;
  std::optional<Every> checkpoint_;
  std::int64_t frames_, data_frames_;
};

}  // namespace freshet
