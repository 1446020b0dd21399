// SPDX-License-Identifier: MIT
#pragma once
#include <chrono>
#include <deque>
#include <optional>

#include "freshet/run.h"
#include "io/checkpoint.h"
#include "io/run_folder.h"
#include "run/background.h"
#include "run/output.h"
#include "run/tables.h"
#include "scene/model/inputs.h"
#include "scene/model/schedule.h"

namespace freshet {

/// Writes the files of a run: asks each output after each step, keeps checkpoints, and ends the run
/// with its result, report and manifest. A thread of its own draws, encodes and writes.
class Observer {
 public:
  /// A run from its start.
  Observer(Simulation& sim, const RunOptions& options);
  /// A resumed run; `record` is that of its checkpoint.
  Observer(Simulation& sim, const ResumeOptions& options, FolderLock lock, RunRecord record);

  /// `seconds`: what steps have taken so far.
  void after_step(double seconds);
  /// Writes a checkpoint of this moment, unless there is one.
  void save();
  /// Writes the last files. Completes the report.
  void finish(Report& report);
  /// After a failure: writes a picture of the moment and closes the manifest. Returns a message
  /// that names the picture and the checkpoint to resume from.
  std::string fail();

  const RunRecord& record() const { return record_; }

 private:
  using Clock = std::chrono::steady_clock;
  Observer(Simulation& sim, FolderLock lock, RunRecord record, Inputs inputs);
  template <class Begin> void begin_or_fail(const Begin& begin);
  void begin(const RunOptions& options);
  void begin(const ResumeOptions& options);
  /// Waits for the background thread; false if a job failed.
  bool come_to_rest() noexcept;
  RunPlan plan() const;
  void write(Output& output, const StepTaken& step);
  void remember_scheduled();

  Simulation& sim_;
  Schedule schedule_;
  RunRecord record_;
  Inputs inputs_;      // read before the folder is cleared, where they may lie
  RunFolder folder_;   // belongs to the background thread, until it has come to rest
  double before_ = 0;  // the last step [s]
  std::int64_t saved_ = -1;
  Clock::time_point saved_at_ = Clock::now();
  std::deque<std::string> checkpoints_;
  Background background_{2};
  Tables tables_;
  ColorRanges ranges_;
  std::vector<std::unique_ptr<Output>> outputs_;
};

}  // namespace freshet
