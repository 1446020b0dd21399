// SPDX-License-Identifier: MIT
/// The surroundings of the fluid in 3D: floor, edges of the domain, walls and bodies.
#pragma once
#include <optional>
#include <vector>

#include "render/band.h"
#include "render/floor.h"
#include "scene/model/loaded_mesh.h"

namespace freshet {

/// The light that a surface reflects. `facing` is the cosine between its normal and the light,
/// `upward` the cosine between its normal and the vertical; the sky lights upward surfaces.
inline float brightness(float facing, float upward) {
  constexpr float ambient = 0.42f;
  return ambient * (0.8f + 0.2f * upward) + (1 - ambient) * std::max(0.0f, facing);
}
float brightness(Point normal);
Color lit(Color c, float light);

struct StageStyle {
  float fluid_opacity;  ///< optical depth of one layer of particles, for their shadow
  bool tiles;           ///< a light floor of tiles, which shows refraction
};

class Stage {
 public:
  /// `view` has samples as its unit of pictures, not pixels.
  Stage(const Scene& scene, const Frame& fluid, const View& view, Color ground,
        const StageStyle& style);

  void draw(Band& band) const;

 private:
  struct Line {
    Point a, b;
  };
  /// The rectangle of samples that a wall may cover.
  struct Extent {
    int left, top, right, bottom;
  };
  struct Mesh {
    std::shared_ptr<const LoadedMesh> loaded;
    bool tank;
  };
  void add_box_lines(Point low, Point high);
  void add_circle(Point center, Point u, Point v);
  void add_tank_lines(const Solid<3, double>& tank);
  Extent extent_of(const Solid<3, double>& solid) const;
  bool seen_from_behind(const Solid<3, double>& plane) const;

  void draw_floor(Band& band) const;
  float tile(double x, double z) const;
  void draw_solid(Band& band, const Solid<3, double>& solid) const;
  void draw_triangle(Band& band, const TriangleMesh& mesh, int triangle, bool tank,
                     Color color) const;
  void draw_line(Band& band, const Line& line) const;
  /// Distance along the line of sight and surface normal where a ray meets a solid.
  struct Hit {
    double z;
    Point normal;
  };
  std::optional<Hit> meet(const Solid<3, double>& solid, Point ray) const;

  View view_;
  Point low_, high_;  // corners of the domain
  bool has_floor_;
  double tile_ = 0;  // side of a tile [m]; 0 for none
  Color floor_, edge_;
  std::vector<Solid<3, double>> solids_;
  std::vector<Mesh> meshes_;
  std::vector<TriangleMesh> bodies_;
  std::vector<Color> body_colors_;
  std::vector<bool> body_tanks_;
  std::vector<Line> lines_;
  std::optional<FloorShadow> shadow_;
};

}  // namespace freshet
