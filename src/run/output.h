// SPDX-License-Identifier: MIT
/// The outputs of a run behind one interface. A new one is a class here and a line in outputs_of().
#pragma once
#include <memory>
#include <string>
#include <vector>

#include "freshet/run.h"
#include "io/checkpoint.h"
#include "io/run_folder.h"
#include "render/color_range.h"
#include "run/background.h"
#include "run/tables.h"
#include "scene/model/schedule.h"

namespace freshet {

/// What every output works with.
struct RunSite {
  Simulation& sim;
  const Schedule& schedule;
  RunRecord& record;
  RunFolder& folder;  ///< belongs to the background thread while a job runs
  Background& background;
  Tables& tables;
  ColorRanges& ranges;  ///< of percentiles.csv so far
};

/// Something that a run writes. It reads the simulation and never changes a step.
class Output {
 public:
  virtual ~Output() = default;
  /// Its key in the record of a run.
  virtual const char* name() const = 0;
  /// The files that it may write, relative to the run's folder.
  virtual std::vector<std::string> files() const = 0;
  /// Writes what is known before the first step. A resumed run skips it.
  virtual void start() {}
  /// Continues what the run had written up to its checkpoint. Returns warnings.
  virtual std::vector<Diagnostic> resume() { return {}; }
  /// Whether it is to write after `step`.
  virtual bool due(const StepTaken& step) const = 0;
  /// Writes the moment after `step`, or gives a background job a copy of it.
  virtual void write(const StepTaken& step) = 0;
  /// Whether the state after the last step is written even where the schedule does not ask for it.
  virtual bool writes_the_end() const { return true; }
  /// Called once after the last write.
  virtual void finish() {}
};

/// In the order in which they write after a step.
std::vector<std::unique_ptr<Output>> outputs_of(const RunSite& site);

}  // namespace freshet
