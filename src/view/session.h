// SPDX-License-Identifier: MIT
/// A simulation or a finished run for a viewer: one thread steps it and publishes snapshots.
#pragma once
#include <filesystem>
#include <memory>
#include <optional>
#include <vector>

#include "view/actions.h"
#include "view/snapshot.h"

namespace freshet::view {

/// Every request returns at once; the thread carries it out between steps. Errors of requests are
/// in the snapshots. Reading snapshots never changes a step: the state has the bits of a run
/// without a viewer, unless keys are changed or the fluid is pushed.
class Session {
 public:
  explicit Session(const Execution& execution = {});
  ~Session();
  Session(const Session&) = delete;

  /// Opens a scene file or the folder of a finished run, paused at its start. Where that fails,
  /// what was open stays. A scene is loaded again whenever its file is saved.
  void open(const std::filesystem::path& path, const std::vector<Override>& overrides = {});
  /// Opens the scene of a log and repeats its actions.
  void replay(const ActionLog& log);
  void play(bool playing);
  /// Takes so many steps, or moves on by so many frames, as fast as possible, and pauses. Later
  /// requests do not wait for them; wait() does.
  void step(std::int64_t count = 1);
  /// Starts again with all changes.
  void restart();
  /// Simulated seconds per second of wall time at most; 0: as fast as possible.
  void set_pace(double pace);
  /// Changes a key: at once if it may change while the simulation runs, else at the next restart.
  void change(const Override& change);
  /// Forgets the changes that wait for a restart.
  void drop_waiting();
  /// Pushes until the next call; empty: no longer.
  void push(const std::optional<Push>& push);
  /// Shows a frame of a finished run.
  void seek(std::size_t frame);
  void save_scene(const std::filesystem::path& file);
  void save_checkpoint(const std::filesystem::path& file);
  void save_log(const std::filesystem::path& file);

  /// The newest snapshot; never null.
  std::shared_ptr<const Snapshot> newest();
  /// Waits until all requests are carried out, with the steps of step(), and returns the snapshot.
  std::shared_ptr<const Snapshot> wait();
  /// The digest of the simulation between steps, after all requests; empty without a simulation.
  std::string state_sha256();

 private:
  class Worker;
  std::unique_ptr<Worker> worker_;
};

}  // namespace freshet::view
