// SPDX-License-Identifier: MIT
#pragma once
#include <chrono>
#include <string>
#include <vector>

#include "freshet/simulation.h"

namespace freshet::cli {

/// Tells how a run goes: a bar on a terminal, lines in a pipe, JSON lines, or nothing.
class Progress {
 public:
  enum class Style { bar, lines, json, quiet };
  explicit Progress(Style style) : style_(style) {}
  static Style choose(bool quiet, bool json);

  void start(const Simulation& sim);
  void update(const Simulation& sim, double seconds);
  /// Ends the bar's line.
  void end();
  /// A line of words, not shown where only JSON or nothing is.
  void say(const std::string& line) const;
  void event(const std::string& json) const;
  Style style() const { return style_; }

 private:
  bool due(double done);
  void show(const Simulation& sim, double seconds);
  double iterations_since_shown(const SolveStatistics& solve) const;
  double remaining(const Simulation& sim);
  using Clock = std::chrono::steady_clock;

  /// Of this run, which may have been resumed.
  struct Moment {
    double wall = 0, time = 0;  ///< [s]
    double particles = 0;
  };

  Style style_;
  Clock::time_point begin_ = Clock::now(), shown_at_{};
  Moment anchor_, next_anchor_;
  double shown_ = 0;  // the share of the run
  std::int64_t shown_step_ = -1;
  std::vector<SolveStatistics> shown_solves_;  // those so far
};

/// Counts on a terminal, unless `quiet`, what a command makes of a finished run.
class Count {
 public:
  Count(bool quiet, const char* noun);
  /// Shows how many of all are done. Returns whether to go on: the user did not ask to stop.
  bool operator()(std::size_t done, std::size_t all) const;
  /// Lets the next line replace the count.
  void finish() const;

 private:
  bool shown_;
  const char* noun_;
};

/// 1234567 -> "1.23 M"
std::string short_number(double value);

/// 1000 -> "16 min 40 s"
std::string duration(double seconds);

/// What the solves of one name came to: iterations, errors, how many did not converge.
std::string solve_words(const SolveStatistics& solve);

}  // namespace freshet::cli
