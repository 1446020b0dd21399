// SPDX-License-Identifier: MIT
/// Particles in simple shapes, and a check of closed meshes.
#pragma once
#include <algorithm>
#include <cmath>
#include <map>
#include <random>
#include <set>
#include <utility>

#include "freshet/surface.h"

namespace freshet::test {

inline Frame fluid_at(std::vector<float> x) {
  Frame frame;
  frame.dimension = 3;
  frame.x = std::move(x);
  frame.v.assign(frame.x.size(), 0);
  for (std::size_t i = 0; i < frame.x.size() / 3; ++i) frame.id.push_back(i);
  return frame;
}

/// A lattice of this spacing inside a shape within ±`reach` lattice sites; sites are moved by up to
/// `jitter` spacings.
template <class Inside> Frame lattice_in(int reach, float spacing, float jitter, Inside inside) {
  std::vector<float> x;
  std::mt19937 random(1);
  std::uniform_real_distribution<float> moved(-jitter, jitter);
  for (int k = -reach; k < reach; ++k)
    for (int j = -reach; j < reach; ++j)
      for (int i = -reach; i < reach; ++i) {
        const float site[] = {(float(i) + 0.5f) * spacing, (float(j) + 0.5f) * spacing,
                              (float(k) + 0.5f) * spacing};
        if (!inside(site[0], site[1], site[2])) continue;
        for (const float s : site) x.push_back(s + spacing * moved(random));
      }
  return fluid_at(std::move(x));
}

inline Frame ball(float radius, float spacing, float jitter) {
  return lattice_in(int(radius / spacing) + 2, spacing, jitter, [=](float x, float y, float z) {
    return x * x + y * y + z * z < radius * radius;
  });
}
/// A box in the middle, of these extents.
inline Frame slab(float width, float height, float spacing, float jitter) {
  return lattice_in(
      int(std::max(width, height) / spacing), spacing, jitter, [=](float x, float y, float z) {
        return std::abs(x) < width / 2 && std::abs(z) < width / 2 && y > 0 && y < height;
      });
}
/// Particles at random places in a cube.
inline Frame cloud(int count, float side, unsigned seed) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<float> place(0, side);
  std::vector<float> x;
  for (int k = 0; k < 3 * count; ++k) x.push_back(place(random));
  return fluid_at(std::move(x));
}

/// The number of defects of a closed manifold mesh: edges that are not in two triangles of opposite
/// directions, triangles with the same corners, corners that coincide, points with more than one
/// fan of triangles around them.
inline int faults_of(const SurfaceMesh& mesh) {
  int faults = 0;
  std::map<std::pair<std::uint32_t, std::uint32_t>, std::uint32_t> follows;  // edge → third corner
  std::set<std::array<std::uint32_t, 3>> triangles;
  std::vector<int> corners(mesh.position.size(), 0);
  for (auto t : mesh.triangles) {
    for (std::size_t c = 0; c < 3; ++c) {
      if (!follows.emplace(std::pair(t[c], t[(c + 1) % 3]), t[(c + 2) % 3]).second) ++faults;
      if (mesh.position[t[c]] == mesh.position[t[(c + 1) % 3]]) ++faults;
      ++corners[t[c]];
    }
    std::sort(t.begin(), t.end());
    if (!triangles.insert(t).second) ++faults;
  }
  for (const auto& [edge, third] : follows)
    if (!follows.contains({edge.second, edge.first})) ++faults;
  if (faults > 0) return faults;
  std::vector<bool> seen(mesh.position.size(), false);
  for (const auto& t : mesh.triangles)
    for (std::size_t c = 0; c < 3; ++c) {
      if (seen[t[c]]) continue;
      seen[t[c]] = true;
      int around = 0;  // walk around the corner until the first neighbour comes again
      std::uint32_t at = t[(c + 1) % 3];
      do {
        at = follows.at({t[c], at});
        ++around;
      } while (at != t[(c + 1) % 3] && around <= corners[t[c]]);
      if (around != corners[t[c]]) ++faults;
    }
  return faults + int(std::count(seen.begin(), seen.end(), false));
}

}  // namespace freshet::test
