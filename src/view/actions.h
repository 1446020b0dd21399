// SPDX-License-Identifier: MIT
/// What a viewer did to a simulation, so that the run can be repeated.
#pragma once
#include <array>
#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "freshet/simulation.h"

namespace freshet::view {

/// A pull on the liquid in a ball, which fades towards its edge, or on a free body at a point.
struct Push {
  std::array<double, 3> center{};  ///< of the ball, or the point of the body [m]
  double radius = 0;               ///< of the ball [m]
  std::array<double, 3> pull{};    ///< acceleration of the liquid [m/s^2]; force on the body [N]
  int body = -1;                   ///< index of the body; -1: the liquid
  bool operator==(const Push&) const = default;
};

/// An intervention after `step` steps.
struct Action {
  enum class Kind { change, push, release };
  std::int64_t step = 0;
  double time = 0;  ///< [s]; for readers, `step` decides
  Kind kind = Kind::change;
  Override change;
  Push push;
};

/// Applies an action between steps. Throws Error (kind scene) as Simulation::change does.
void apply(Simulation& simulation, const Action& action);

/// The actions of a run from its start.
struct ActionLog {
  std::filesystem::path scene;
  std::vector<Override> overrides;  ///< of the scene at the start
  std::vector<Action> actions;      ///< by step

  /// TOML. Numbers have all of their digits.
  std::string text() const;
};
/// Parses the text of a log. `scene` is relative to the folder of `file`. Throws Error (kind
/// scene) at FILE for text that is not a log.
ActionLog parse_log(const std::string& text, const std::filesystem::path& file);
ActionLog read_log(const std::filesystem::path& file);

}  // namespace freshet::view
