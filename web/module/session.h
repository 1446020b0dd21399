// SPDX-License-Identifier: MIT
#pragma once
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "freshet/derived.h"
#include "freshet/simulation.h"
#include "render/color_range.h"
#include "render/image.h"
#include "view/stage.h"

namespace freshet::web {

/// A scene as the page asks for it.
struct Request {
  std::string text;     ///< TOML
  std::string name;     ///< the file name in messages
  std::string solver;   ///< replaces the scene's, as `freshet run --solver`; the scene's if empty
  std::string changes;  ///< overrides, one a line: "KEY=VALUE", or "KEY" to remove it
};

/// The scene of a request. Throws Error (kind scene). `warnings` receives the keys that another
/// solver drops and the warnings for the scene.
Scene scene_of(const Request& request, std::vector<Diagnostic>& warnings);

/// One simulation and what the page draws of it.
class Session {
 public:
  /// Throws Error (kind scene) for an invalid scene.
  explicit Session(const Request& request);

  /// Takes at most so many steps, for about so long [ms], and with `past_end` beyond time.end.
  void step(int steps, double milliseconds, bool past_end);
  const Simulation& simulation() const { return sim_; }

  /// Moves the particles to where they are in another session, by their ids, if both have the same.
  void take_particles(const Session& other);
  void set_gravity(const Vector& gravity) { sim_.set_gravity(gravity); }
  /// An acceleration [m/s²] around a place [m] that fades out at a radius; none if it is 0.
  struct Push {
    double place[3], acceleration[3], radius;
  };
  void push(const Push& push);

  /// What the page draws now, coloured by a quantity.
  const view::Shown& update(ColorBy quantity);
  const std::vector<float>& packed_stage() const { return packed_stage_; }
  /// The picture of a 2D scene, as a run writes it; empty in 3D.
  const Image& picture();

  /// What the panels show: the scene, derived numbers, statistics, solves and warnings, as JSON.
  std::string about() const;
  std::string state() const;
  /// The pixel counts of the picture, as JSON.
  std::string picture_pixels();

 private:
  std::vector<Diagnostic> warnings_;
  Simulation sim_;
  Derived derived_;
  Scene coloring_scene_;  // with the colours that are chosen
  view::Stage stage_;
  std::vector<float> packed_stage_;
  ColorRanges ranges_;
  view::Shown shown_;
  std::optional<Image> picture_;
};

/// The warnings of diagnostics, one a line.
std::string lines_of(const std::vector<Diagnostic>& diagnostics);

}  // namespace freshet::web
