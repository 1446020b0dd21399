// SPDX-License-Identifier: MIT
/// The thread of a session.
#pragma once
#include <atomic>
#include <chrono>
#include <condition_variable>
#include <deque>
#include <functional>
#include <mutex>
#include <thread>

#include "view/live_run.h"
#include "view/pace.h"
#include "view/played_run.h"
#include "view/session.h"

namespace freshet::view {

class Session::Worker {
 public:
  explicit Worker(const Execution& execution);
  ~Worker();

  /// Queues a request, which the thread carries out between steps.
  void post(std::function<void()> request);
  /// Queues it and waits until it is carried out.
  void post_and_wait(std::function<void()> request);
  std::shared_ptr<const Snapshot> newest();
  std::shared_ptr<const Snapshot> wait();

  // Requests: only the thread calls them.
  void open(const std::filesystem::path& path, const std::vector<Override>& overrides);
  void replay(const ActionLog& log);
  void play(bool playing);
  void step(std::int64_t count);
  void restart();
  void change(const Override& change);
  void drop_waiting();
  void push(const std::optional<Push>& push);
  void seek(std::size_t frame);
  void save_scene(const std::filesystem::path& file);
  void save_checkpoint(const std::filesystem::path& file);
  void save_log(const std::filesystem::path& file);
  Pace pace;
  const Simulation* simulation() const { return live_ ? &live_->simulation() : nullptr; }

 private:
  using Clock = std::chrono::steady_clock;

  void loop();
  void begin(const ActionLog& log);
  /// Carries out the requests that wait; false: the session ends.
  bool take_requests();
  /// Calls f and keeps the errors that it throws.
  void guard(const std::function<void()>& f);
  bool active() const { return (playing_ || steps_left_ > 0) && (live_ || played_) && !failed_; }
  void advance();
  void advance_live();
  void advance_played();
  void publish();
  void publish_if_due();
  void watch_file();
  void done(std::string notice);
  LiveRun& live(const char* request);

  Execution execution_;
  std::string name_;
  std::vector<Override> base_, overrides_, waiting_;  // of the command; with all changes
  std::optional<LiveRun> live_;
  std::unique_ptr<PlayedRun> played_;
  std::filesystem::path watched_;
  std::filesystem::file_time_type saved_{};
  bool playing_ = false, failed_ = false;
  std::int64_t steps_left_ = 0;
  std::uint64_t run_ = 0, number_ = 0, notices_ = 0;
  double step_seconds_ = 0;
  std::vector<Diagnostic> problems_;
  std::string notice_;
  std::shared_ptr<const Snapshot> measured_;  // the last with statistics
  Clock::time_point last_publish_{}, last_measure_{}, last_watch_{};
  Clock::duration publish_cost_{}, measure_cost_{};

  std::mutex mutex_;
  std::condition_variable wake_, idle_;
  std::deque<std::function<void()>> requests_;
  bool quit_ = false, busy_ = false;
  std::shared_ptr<const Snapshot> newest_;
  std::atomic<bool> wanted_{true};
  std::thread thread_;
};

}  // namespace freshet::view
