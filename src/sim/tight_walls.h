// SPDX-License-Identifier: MIT
#pragma once
#include <array>
#include <cstdint>
#include <optional>
#include <vector>

#include "engine/engine.h"
#include "scene/sample/membranes.h"

namespace freshet {

/// Keeps particles on their side of walls without an inside. Boundary particles hold a fluid, but a
/// lone particle passes between them: beside a sheet, its density is below rest density on both
/// sides. A particle whose step crosses a membrane therefore slides along it instead, and loses the
/// speed towards it.
class TightWalls {
 public:
  TightWalls(const Scene& scene, double support);

  bool any() const { return membranes_.has_value(); }
  /// Call before a step.
  void begin(const ParticleView& fluid);
  /// Call after the step. Returns the number of particles that it has stopped.
  std::int64_t hold(Engine& engine);

 private:
  using Point = TriangleMesh::Point;
  struct Start {
    std::uint64_t id;
    std::size_t place;  ///< of its coordinates in x_
    bool operator<(const Start& other) const { return id < other.id; }
  };

  bool hold(const ParticleView& fluid, const Real* before, std::span<Real> x,
            std::span<Real> v) const;
  void mark_near_cells(double cell);
  void mark(int triangle);
  bool is_near(Point x) const;
  Point normal_against(int triangle, Point way) const;

  std::optional<MeshDistance> membranes_;
  std::size_t dimension_;
  std::array<double, 3> period_{};  // [m]; 0: not periodic
  Point low_{};                     // of the cells
  double cell_ = 0;
  std::array<std::int64_t, 3> count_{1, 1, 1};
  std::vector<std::uint8_t> near_;  // by cell
  std::vector<Start> starts_;       // of the particles near membranes, before the step
  std::vector<Real> x_;             // as the engine has them
};

}  // namespace freshet
