// SPDX-License-Identifier: MIT
#pragma once
#include <condition_variable>
#include <deque>
#include <exception>
#include <functional>
#include <mutex>
#include <thread>

namespace freshet {

/// Does jobs one after the other on a thread of its own, while the simulation goes on. No more than
/// `most` jobs wait: what they hold in memory is bounded, and a slow disk slows the simulation.
class Background {
 public:
  /// Throws Error (kind run) if the system does not start a thread.
  explicit Background(std::size_t most);
  /// Ends after the job that runs; those that wait are dropped.
  ~Background();
  Background(const Background&) = delete;
  Background& operator=(const Background&) = delete;

  /// Waits for room. Throws what a job threw; after that no job is done any more.
  void add(std::function<void()> job);
  /// Waits until all jobs are done, and throws what one threw.
  void wait();

 private:
  void work();
  void throw_failure();

  std::size_t most_;
  std::mutex mutex_;
  std::condition_variable changed_;
  std::deque<std::function<void()>> jobs_;
  std::exception_ptr failure_;
  bool busy_ = false, ending_ = false;
  std::thread thread_;
};

}  // namespace freshet
