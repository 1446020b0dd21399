// SPDX-License-Identifier: MIT
/// Scenes of SPlisHSPlasH for tests, and the meshes that they name.
#pragma once
#include <fmt/format.h>

#include <cmath>
#include <numbers>
#include <string>
#include <vector>

#include "cli/files.h"
#include "freshet/import.h"
#include "freshet/scene.h"

namespace freshet::test {

/// The message of the Error that `import` throws, without the folder; empty without an error.
template <class Import>
std::string refusal_of(const Import& import, const std::filesystem::path& in) {
  try {
    import();
    return "";
  } catch (const Error& e) {
    std::string what = e.what();
    const std::string folder = in.string() + "/";
    for (std::size_t at; (at = what.find(folder)) != std::string::npos;)
      what.erase(at, folder.size());
    return what;
  }
}

/// The PLY text of a mesh.
inline std::string ply_text(const std::vector<Vector>& points,
                            const std::vector<std::vector<int>>& faces) {
  std::string text = fmt::format(
      "ply\nformat ascii 1.0\nelement vertex {}\nproperty float x\nproperty float y\n"
      "property float z\nelement face {}\nproperty list uchar int vertex_indices\nend_header\n",
      points.size(), faces.size());
  for (const Vector& p : points) text += fmt::format("{} {} {}\n", p[0], p[1], p[2]);
  for (const auto& f : faces) {
    text += std::to_string(f.size());
    for (const int k : f) text += fmt::format(" {}", k);
    text += "\n";
  }
  return text;
}

/// A cube of edge 1 around the origin, as the UnitBox of SPlisHSPlasH.
inline std::string unit_box() {
  std::vector<Vector> points;
  for (int k = 0; k < 8; ++k)
    points.push_back({k & 1 ? 0.5 : -0.5, k & 2 ? 0.5 : -0.5, k & 4 ? 0.5 : -0.5});
  return ply_text(
      points, {{0, 2, 3, 1}, {4, 5, 7, 6}, {0, 1, 5, 4}, {2, 6, 7, 3}, {0, 4, 6, 2}, {1, 3, 7, 5}});
}

/// A prism of radius 1 around y, from -1 to 1, with n corners; a pyramid of n sides for tip = 0.
inline std::string prism(int n, double tip = 1) {
  std::vector<Vector> points;
  std::vector<int> bottom, top;
  std::vector<std::vector<int>> faces;
  for (int k = 0; k < n; ++k) {
    const double a = 2 * std::numbers::pi * k / n;
    points.push_back({std::cos(a), -1, std::sin(a)});
    points.push_back({tip * std::cos(a), 1, tip * std::sin(a)});
    bottom.push_back(2 * k);
    top.insert(top.begin(), 2 * k + 1);
    const int next = (k + 1) % n;
    faces.push_back({2 * k, 2 * k + 1, 2 * next + 1, 2 * next});
  }
  faces.push_back(bottom);
  faces.push_back(top);
  return ply_text(points, faces);
}

/// A dam break in a tank of 1 x 1 x 0.5 m.
inline const std::string dam_json = R"({
  "Configuration": {"particleRadius": 0.025, "simulationMethod": 4, "stopAt": 0.05,
                    "cflMaxTimeStepSize": 0.005, "boundaryHandlingMethod": 0},
  "Materials": [{"id": "Fluid", "density0": 900, "viscosityMethod": 1,
                 "Standard viscosity": {"viscosity": 0.01}}],
  "RigidBodies": [{"geometryFile": "box.ply", "translation": [0, 0.5, 0], "scale": [1, 1, 0.5],
                   "isWall": true, "mapInvert": true}],
  "FluidBlocks": [{"start": [-0.5, 0, -0.25], "end": [0, 0.5, 0.25]}]
})";

/// A folder with scene.json and the meshes box.ply, prism.ply (24 corners) and cone.ply.
class ImportFolder : public TemporaryFolder {
 public:
  explicit ImportFolder(const std::string& json = dam_json) {
    write_text(*this / "box.ply", unit_box());
    write_text(*this / "prism.ply", prism(24));
    write_text(*this / "cone.ply", prism(24, 0.3));
    write_text(file(), json);
  }
  fs::path file() const { return *this / "scene.json"; }
  ImportedScene import() const { return import_splishsplash(file(), path()); }
  Scene scene() const { return parse_scene(import().toml, (*this / "scene.toml").string()); }
  /// The error message of importing it, without the folder; empty without an error.
  std::string refused() const {
    return refusal_of([&] { import(); }, path());
  }
};

/// dam_json with `to` in place of `from`.
inline std::string dam_with(const std::string& from, const std::string& to) {
  std::string json = dam_json;
  const auto at = json.find(from);
  EXPECT_NE(at, std::string::npos) << from;
  return json.replace(at, from.size(), to);
}

}  // namespace freshet::test
