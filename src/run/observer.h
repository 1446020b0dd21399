// SPDX-License-Identifier: MIT
/// What a run leaves behind, written while it goes on.
#pragma once
#include <chrono>
#include <deque>
#include <optional>

#include "freshet/run.h"
#include "io/checkpoint.h"
#include "io/run_folder.h"
#include "io/video.h"
#include "run/background.h"
#include "scene/model/inputs.h"
#include "scene/model/schedule.h"
#include "sim/probes.h"

namespace freshet {

/// Copies what is to be written after a step, and lets a thread of its own draw, encode and write.
class Observer {
 public:
  /// A run from its start.
  Observer(Simulation& sim, const RunOptions& options);
  /// A run that goes on; `record` is what the checkpoint remembers.
  Observer(Simulation& sim, const ResumeOptions& options, FolderLock lock, RunRecord record);

  /// `seconds`: what steps have taken so far.
  void after_step(double seconds);
  /// A checkpoint of now, unless there is one.
  void save();
  /// The last files. Completes the report.
  void finish(Report& report);
  /// After a failure: a picture of the moment, and the manifest's last word. Returns in words what
  /// there is to look at and to go on from.
  std::string fail();

  const RunRecord& record() const { return record_; }

 private:
  using Clock = std::chrono::steady_clock;
  void after_last_step();
  void observe();
  void probe(const StepTaken& step);
  void draw_frame();
  void film();
  void write_data();
  void write_observables();
  void remember_scheduled();
  void note_bodies();

  Simulation& sim_;
  Schedule schedule_;
  RunRecord record_;
  Probes probes_;
  Inputs inputs_;     // read before the folder is cleared, where they may lie
  RunFolder folder_;  // the background's, until it has come to rest
  std::optional<VideoOptions> video_;
  std::optional<Video> film_;
  std::int64_t filmed_ = 0;
  double before_ = 0;  // the last step [s]
  std::int64_t saved_ = -1;
  Clock::time_point saved_at_ = Clock::now();
  std::deque<std::string> checkpoints_;
  Background background_{2};  // last: its jobs use the others
};

}  // namespace freshet
