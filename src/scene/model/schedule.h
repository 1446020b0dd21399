// SPDX-License-Identifier: MIT
#pragma once
#include <algorithm>
#include <cmath>
#include <optional>
#include <vector>

#include "freshet/scene.h"

namespace freshet {

/// A completed step: its number, counted from 0, and the time before and after it [s].
struct StepTaken {
  std::int64_t step;
  double before, after;
  bool last;  ///< the last step of the run
};

/// When something is written: at the start, at the end, and at an interval of steps or seconds in
/// between. Rows of tables are written after a step: with seconds, after the first step at or after
/// each such time. Frames show the fluid at exactly these times, also within a step.
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
  /// The times of the frames of a step: after `before`, or from 0 in step 0, up to `after`. The end
  /// of a run is not in it, unless the interval makes it due.
  std::vector<double> frames_in(const StepTaken& s) const {
    if (steps_ > 0)
      return s.step % steps_ == 0 ? std::vector<double>{s.after} : std::vector<double>{};
    std::vector<double> times;
    if (s.step == 0) times.push_back(0);
    for (double k = times_by(s.before) + 1, last = times_by(s.after); k <= last; ++k)
      times.push_back(k * seconds_ > s.after - close * seconds_ ? s.after : k * seconds_);
    return times;
  }
  /// Whether a frame may show a moment after `from` and before `to`, or at `from` = 0.
  bool frames_between(double from, double to) const {
    return steps_ == 0 && (from == 0 || times_by(to) > times_by(from));
  }
  /// The number of frames of a run that ends at `end` after this many steps, which do not matter if
  /// the interval is in seconds.
  std::int64_t frames(std::int64_t steps, double end) const {
    const std::int64_t last = steps - 1;
    if (steps_ > 0) return last / steps_ + 1 + (last % steps_ != 0);
    const double due = times_by(end);
    return whole(due) + 1 + (end - due * seconds_ > close * seconds_);
  }

 private:
  /// The number of times k·seconds, k > 0, up to t, with a tolerance for rounding.
  double times_by(double t) const { return std::floor(t / seconds_ + close); }
  static std::int64_t whole(double count) { return std::int64_t(std::min(count, 9e15)); }

  static constexpr double close = 1e-9;  // intervals: rounding of times

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
        surface_(surface_of(s)),
        probes_(probes_of(s)),
        checkpoint_(
            s.output.checkpoint_every_steps || s.output.checkpoint_every
                ? std::optional<Every>({s.output.checkpoint_every_steps, s.output.checkpoint_every})
                : std::nullopt),
        frames_(frames(s, frame_)),
        data_frames_(s.output.data.empty() ? 0 : frames(s, data_)),
        surface_frames_(s.surface ? frames(s, surface_) : 0) {}

  /// The frames, the data files and the meshes of the fluid.
  const Every& frame() const { return frame_; }
  const Every& data() const { return data_; }
  const Every& surface() const { return surface_; }
  /// Whether the k-th probe measures.
  bool probe_after(std::size_t k, const StepTaken& s) const { return probes_[k].due(s); }
  bool observe_after(const StepTaken& s) const { return observe_.due(s); }
  /// Whether the interval of the scene makes a checkpoint due. Without one, the clock decides.
  bool checkpoint_after(const StepTaken& s) const {
    return checkpoint_ && checkpoint_->due_within(s);
  }
  bool checkpoints_by_clock() const { return !checkpoint_; }
  /// The number of frames of a run. Of adaptive steps counted, the minimum.
  std::int64_t frames() const { return frames_; }
  /// The number of data files of each format; likewise.
  std::int64_t data_frames() const { return data_frames_; }
  /// The number of frames with meshes of the fluid; likewise.
  std::int64_t surface_frames() const { return surface_frames_; }

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
  static Every surface_of(const Scene& s) {
    const auto& o = s.surface;
    return o && (o->every_steps || o->every) ? every(s, o->every_steps, o->every, 10) : data_of(s);
  }
  static std::vector<Every> probes_of(const Scene& s) {
    std::vector<Every> all;
    for (const Scene::Probe& p : s.probe)
      all.push_back(
          p.every ? Every({}, p.every)
                  : every(s, s.output.observables_every_steps, s.output.observables_every, 100));
    return all;
  }
  static std::int64_t frames(const Scene& s, const Every& e) {
    return e.frames(s.steps(), s.time.adaptive ? s.time.end : double(s.steps()) * s.time.step);
  }

  Every frame_, observe_, data_, surface_;
  std::vector<Every> probes_;
  std::optional<Every> checkpoint_;
  std::int64_t frames_, data_frames_, surface_frames_;
};

}  // namespace freshet
