// SPDX-License-Identifier: MIT
#pragma once
#include <array>
#include <filesystem>
#include <vector>

#include "freshet/scene.h"

namespace freshet {

/// The key frames in a CSV file. Throws Error (kind scene) at FILE, or at FILE:LINE.
std::vector<Scene::Body::Key> read_body_path(const std::filesystem::path& file, int dimension);

/// The displacement of a moved body from its start, and its rate: x, y, z [m, m/s] and the angle
/// about its pivot [rad, rad/s].
struct Displacement {
  std::array<double, 4> value{}, rate{};
};

/// The prescribed motion of a body of a scene with its defaults filled in.
///
/// The rates of functions are finite differences of fourth order: central, and one-sided at the
/// start. Between key frames the motion is linear or a cubic. The slope of the cubics at a key
/// frame is that of the parabola through it and its neighbours; it is 0 at the first and the last.
/// The body is at rest before the first key frame and after the last.
class PrescribedMotion {
 public:
  PrescribedMotion(const Scene::Body& body, int dimension);
  PrescribedMotion(PrescribedMotion&&) noexcept;
  ~PrescribedMotion();
  /// Not thread-safe.
  Displacement at(double time) const;

 private:
  struct Functions;
  std::array<double, 4> functions_at(double time) const;
  Displacement between_keys(double time) const;

  std::unique_ptr<Functions> functions_;
  std::vector<double> times_;
  std::vector<std::array<double, 4>> values_, slopes_;
  bool linear_ = false;
};

/// An upper bound on the speed of all points of a moved body until `end` [m/s], from 1001 times.
double fastest_point(const Scene::Body& body, int dimension, double end);

}  // namespace freshet
