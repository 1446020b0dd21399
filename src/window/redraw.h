// SPDX-License-Identifier: MIT
#pragma once

namespace freshet::window {

/// Decides when a window is drawn anew: for a new snapshot, for events, and rarely at rest. Panels
/// need some pictures until they have answered an event.
class Redraw {
 public:
  /// `now` [s]: of any clock.
  bool wanted(bool snapshot, bool event, double now) {
    if (event) answers_ = 5;
    if (!snapshot && answers_ == 0 && now - last_ < rest) return false;
    if (answers_ > 0) --answers_;
    last_ = now;
    return true;
  }

 private:
  static constexpr double rest = 0.5;  ///< between pictures without a cause [s]
  int answers_ = 5;
  double last_ = -rest;
};

}  // namespace freshet::window
