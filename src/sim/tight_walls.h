// SPDX-License-Identifier: MIT
#pragma once
#include <array>
#include <cstdint>
#include <optional>
#include <vector>

#include "bodies/bodies.h"
#include "engine/engine.h"
#include "freshet/derived.h"
#include "scene/sample/membranes.h"
#include "sim/body_cells.h"
#include "sim/near_cells.h"

namespace freshet {

/// Keeps particles on their side of sheets, walls of points and thin solids. Boundary particles
/// hold a fluid, but a lone particle passes between them, and through a thin solid it comes out on
/// the other side. A particle whose step crosses a membrane therefore slides along it instead, and
/// loses the speed towards it. A free body receives the impulse.
class TightWalls {
 public:
  /// Keeps `bodies`, which may be null.
  TightWalls(const Scene& scene, const Derived& derived, Bodies* bodies);

  bool any() const { return !guards_.empty(); }
  /// Call before a step.
  void begin(const ParticleView& fluid);
  /// Call after the step. Returns the number of particles that it has stopped.
  std::int64_t hold(Engine& engine);

 private:
  using Point = TriangleMesh::Point;
  struct Start {
    std::uint64_t id;
    Point x;  ///< relative to the body at its start
    bool operator<(const Start& other) const { return id < other.id; }
  };
  struct Guard {
    Membrane membrane;
    NearCells near;
    double radius = 0;          ///< of a ball around the body that holds what is near [m]
    std::vector<Start> starts;  ///< of the particles near it, before the step
  };
  /// Vectors are relative to the body at its start.
  struct Held {
    std::size_t place;  ///< of the particle
    std::uint64_t id;
    Point move, normal;
    std::optional<Point> second_normal;
  };
  class Pose;

  Pose pose_of(const Guard& guard) const;
  std::vector<std::vector<std::size_t>> candidates(const ParticleView& fluid);
  std::vector<Held> crossings(const Guard& guard, const Pose& pose, const ParticleView& f,
                              const std::vector<std::size_t>& candidates) const;
  void apply(const Held& one, int body, const Pose& pose, Engine& engine) const;
  static std::optional<Held> held(const Membrane& membrane, Point from, Point way);
  void stop(std::span<Real> v, double mass, Point x, Point normal, int body) const;

  std::size_t dimension_;
  double reach_;                    // of what is near a membrane [m]
  std::array<double, 3> period_{};  // [m]; 0: not periodic
  std::vector<double> masses_;      // of the particles of each liquid [kg; kg/m in 2D]
  Bodies* bodies_;
  std::vector<Guard> guards_;
  std::optional<BodyCells> cells_;  // of the bodies
};

}  // namespace freshet
