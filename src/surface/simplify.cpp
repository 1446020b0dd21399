// SPDX-License-Identifier: MIT
#include "surface/simplify.h"

#include <algorithm>
#include <cmath>

#include "surface/mesh_defects.h"
#include "surface/smoothing.h"
#include "surface/unfold.h"

#ifdef FRESHET_MESHOPTIMIZER
#include <meshoptimizer.h>
#endif

namespace freshet {
namespace {

using Triangle = GridMesh::Triangle;

/// A chunk is simplified alone, with the edges at its border in place: in its own coordinates,
/// 32-bit floats are exact enough.
constexpr int chunk_cells = 64;

/// Triangles that are simplified together, up to an error [cells].
struct Chunk {
  std::vector<Triangle> before, after;
  double error = 0;
};

std::vector<Chunk> chunks_of(const GridMesh& mesh) {
  std::vector<std::pair<std::uint64_t, std::uint32_t>> order;
  order.reserve(mesh.triangles.size());
  const auto place = [](double x) { return int(std::floor(x / chunk_cells)); };
  for (const Triangle& t : mesh.triangles) {
    const GridMesh::Point p = mesh.points[t[0]];
    order.emplace_back(key_of({place(p.x), place(p.y), place(p.z)}), std::uint32_t(order.size()));
  }
  std::sort(order.begin(), order.end());
  std::vector<Chunk> chunks;
  std::uint64_t key = 0;
  for (const auto& [own, k] : order) {
    if (chunks.empty() || own != key) chunks.emplace_back();
    key = own;
    chunks.back().before.push_back(mesh.triangles[k]);
  }
  return chunks;
}

#ifdef FRESHET_MESHOPTIMIZER
void simplify_chunk(Chunk& chunk, const GridMesh& mesh) {
  std::vector<std::uint32_t> points;
  for (const Triangle& t : chunk.before) points.insert(points.end(), t.begin(), t.end());
  std::sort(points.begin(), points.end());
  points.erase(std::unique(points.begin(), points.end()), points.end());
  std::vector<unsigned> corners, out(3 * chunk.before.size());
  for (const Triangle& t : chunk.before)
    for (const std::uint32_t c : t)
      corners.push_back(
          unsigned(std::lower_bound(points.begin(), points.end(), c) - points.begin()));
  std::vector<float> x;
  const GridMesh::Point from = mesh.points[points.front()];
  for (const std::uint32_t k : points) {
    const GridMesh::Point p = mesh.points[k] - from;
    x.insert(x.end(), {float(p.x), float(p.y), float(p.z)});
  }
  constexpr std::size_t stride = 3 * sizeof(float);
  const float scale = meshopt_simplifyScale(x.data(), points.size(), stride);
  const std::size_t count =
      meshopt_simplify(out.data(), corners.data(), corners.size(), x.data(), points.size(), stride,
                       0, float(chunk.error) / scale, meshopt_SimplifyLockBorder, nullptr);
  chunk.after.clear();
  for (std::size_t k = 0; k < count; k += 3)
    chunk.after.push_back({points[out[k]], points[out[k + 1]], points[out[k + 2]]});
}
#else
void simplify_chunk(Chunk& chunk, const GridMesh&) { chunk.after = chunk.before; }
#endif

/// Simplifies a chunk again with a smaller error, and in the end not at all.
void simplify_less(Chunk& chunk, const GridMesh& mesh, double error) {
  constexpr double factor = 0.4, least = 0.1;
  chunk.error *= factor;
  if (chunk.error > least * error) simplify_chunk(chunk, mesh);
  else chunk.after = chunk.before;
}

/// Joins the chunks. Edges of two chunks may connect the same points of their border: where
/// triangles do not fit, their chunks are simplified less.
std::vector<Triangle> joined(std::vector<Chunk>& chunks, const GridMesh& mesh, double error) {
  for (;;) {
    std::vector<Triangle> all;
    std::vector<std::size_t> of;  // the chunk of each triangle
    for (std::size_t k = 0; k < chunks.size(); ++k) {
      all.insert(all.end(), chunks[k].after.begin(), chunks[k].after.end());
      of.resize(all.size(), k);
    }
    std::vector<std::size_t> wrong;
    for (const std::uint32_t t : defective_triangles(all)) wrong.push_back(of[t]);
    if (wrong.empty()) return all;
    std::sort(wrong.begin(), wrong.end());
    wrong.erase(std::unique(wrong.begin(), wrong.end()), wrong.end());
    for (const std::size_t k : wrong) simplify_less(chunks[k], mesh, error);
  }
}

/// Returns the former number of each point that stays.
std::vector<std::uint32_t> drop_unused_points(GridMesh& mesh) {
  std::vector<bool> used(mesh.points.size(), false);
  for (const Triangle& t : mesh.triangles)
    for (const std::uint32_t c : t) used[c] = true;
  std::vector<std::uint32_t> kept, number(mesh.points.size());
  for (std::uint32_t k = 0; k < used.size(); ++k) {
    if (!used[k]) continue;
    number[k] = std::uint32_t(kept.size());
    mesh.points[kept.size()] = mesh.points[k];
    kept.push_back(k);
  }
  mesh.points.resize(kept.size());
  mesh.block_end.clear();
  for (Triangle& t : mesh.triangles)
    for (std::uint32_t& c : t) c = number[c];
  return kept;
}

}  // namespace

std::vector<std::uint32_t> simplify(GridMesh& mesh, double error, const Threads& threads) {
  const std::vector<GridMesh::Point> normals = area_vectors(mesh);
  std::vector<Chunk> chunks = chunks_of(mesh);
  threads.parts(int(chunks.size()), [&](int k) {
    chunks[std::size_t(k)].error = error;
    simplify_chunk(chunks[std::size_t(k)], mesh);
  });
  mesh.triangles = joined(chunks, mesh, error);
  unfold(mesh, normals);
  return drop_unused_points(mesh);
}

}  // namespace freshet
