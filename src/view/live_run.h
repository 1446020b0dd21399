// SPDX-License-Identifier: MIT
#pragma once
#include <filesystem>
#include <optional>
#include <vector>

#include "sim/probes.h"
#include "view/actions.h"
#include "view/snapshot.h"

namespace freshet::view {

/// A simulation that a viewer intervenes in. It records what was done.
class LiveRun {
 public:
  /// Loads the scene of the log with its overrides. Repeats the log's actions at their steps.
  LiveRun(const ActionLog& log, const Execution& execution);

  void step();
  bool ended() const { return sim_.finished(); }
  const Simulation& simulation() const { return sim_; }
  /// Changes a key at once. Throws Error (kind scene), and changes nothing, as Simulation::change.
  void change(const Override& change);
  void push(const std::optional<Push>& push);
  /// The log so far; with what is still to be repeated if `whole`.
  ActionLog log(bool whole = false) const;
  /// Writes the scene and the frame; the rest if `all`, which costs more passes.
  void show(Snapshot& snapshot, bool all);

 private:
  void record(const Action& action);
  void repeat();
  void measure(Snapshot& snapshot);

  ActionLog log_;
  std::vector<Action> to_repeat_;  // the next one last
  Simulation sim_;
  std::shared_ptr<const Scene> scene_;  // the simulation's; what a snapshot keeps
  std::optional<Probes> probes_;
  std::optional<Push> pushed_;
  double support_radius_;
};

}  // namespace freshet::view
