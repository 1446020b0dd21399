// SPDX-License-Identifier: MIT
#pragma once
#include <array>
#include <filesystem>
#include <vector>

#include "freshet/scene.h"

namespace freshet {

/// The key frames in a CSV file. Throws Error (kind scene) at FILE, or at FILE:LINE.
std::vector<Scene::Body::Key> read_body_path(const std::filesystem::path& file, int dimension);

/// How far a moved body is from its place at the start, and how fast: x, y, z [m, m/s], and the
/// angle about its pivot [rad, rad/s].
struct Displacement {
  std::array<double, 4> value{}, rate{};
};

/// The prescribed motion of a body of a scene with its defaults filled in.
///
/// Functions: by value, their rates by central differences of fourth order. Key frames: a cubic
/// between two of them whose slopes are those of the parabola through three, zero at the first and
/// the last; or straight lines. Before the first and after the last it stands still.
class PrescribedMotion {
 public:
  PrescribedMotion(const Scene::Body& body, int dimension);
  PrescribedMotion(PrescribedMotion&&) noexcept;
  ~PrescribedMotion();
  /// Not for two threads at once.
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

}  // namespace freshet
