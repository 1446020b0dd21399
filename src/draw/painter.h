// SPDX-License-Identifier: MIT
/// Draws a frame and its surroundings with OpenGL: the same for a window and a web page.
#pragma once
#include <memory>
#include <optional>
#include <vector>

#include "draw/program.h"
#include "view/pick.h"
#include "view/stage.h"

namespace freshet::gl {

enum class Style { balls, water };

/// The background of water.
inline constexpr view::Tint daylight{0.80f, 0.87f, 0.93f, 1};

/// How a frame is shown.
struct Look {
  Style style = Style::balls;  ///< water in 3D only
  view::Slice slice;           ///< 3D
  bool walls = true, bodies = true, probes = true, floor = true, foam = true;
  float size = 1;  ///< of particles: a factor of their diameter
  view::Tint background{0.03f, 0.04f, 0.11f, 1};
  std::optional<std::size_t> marked;  ///< a particle
  bool soft = false;                  ///< discs have smooth edges
  int water_detail = 1;               ///< the liquid is computed for every so many pixels
};

class Water;

class Painter {
 public:
  /// Needs a current context whose functions load_gl has found. Throws Error (kind run) if a shader
  /// does not compile.
  Painter();
  ~Painter();

  /// Walls, bodies and probes of a scene.
  void set_stage(const view::Stage& stage);
  void set_frame(const view::Shown& shown);
  /// A rectangle of the window [px].
  struct Region {
    int left, width, height;
    double aspect() const { return double(width) / height; }
  };
  /// Draws into a region of the framebuffer `into`, and clears the rest.
  void draw(const view::Camera& camera, const Look& look, const Region& region, GLuint into = 0);
  std::size_t particles() const { return std::size_t(balls_.count()); }

 private:
  struct Moving {
    view::Part::Kind kind;
    view::Tint fill, edge;
    Vertices triangles, lines, points;
    view::Matrix placement;
  };
  struct Sight;

  void draw_stage(const Sight& sight, const Look& look);
  void draw_floor(const Sight& sight, const Look& look);
  void draw_points(const Sight& sight, const Look& look);
  void draw_balls(const Sight& sight, const Look& look);
  void draw_discs(const Look& look);
  const Program& use_balls(const Sight& sight, const Look& look) const;
  void draw_foam(const Sight& sight, const Look& look, bool on_water);

  Program ball_, disc_, solid_, line_, floor_, foam_;
  Vertices balls_, foam_points_, floor_square_;
  std::vector<Moving> parts_;
  GLuint map_ = 0;
  bool flat_ = true;
  float spacing_ = 1, glow_ = 0;
  Point low_{}, high_{};
  std::unique_ptr<Water> water_;  // made when it is needed
};

}  // namespace freshet::gl
