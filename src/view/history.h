// SPDX-License-Identifier: MIT
#pragma once
#include <string>
#include <vector>

#include "view/snapshot.h"

namespace freshet::view {

/// Numbers over time of the snapshots of a run, for plots.
class History {
 public:
  using Series = SeriesOverTime::Series;
  /// Begins anew where the snapshot is of another run. Skips snapshots that are not later.
  void add(const Snapshot& snapshot);
  const std::vector<float>& times() const { return all_.times; }
  const std::vector<Series>& series() const { return all_.series; }
  const SeriesOverTime& all() const { return all_; }

 private:
  /// Keeps every second moment: the resolution halves as the run grows.
  void thin_out();

  static constexpr std::size_t most = 2048;
  std::uint64_t run_ = 0;
  float interval_ = 0;  // minimum between moments [s]
  SeriesOverTime all_;
};

}  // namespace freshet::view
