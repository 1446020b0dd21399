// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "formats/ply_file.h"
#include "mesh/mesh_formats.h"

namespace freshet {
namespace {

constexpr std::size_t most_ply_items = std::numeric_limits<int>::max();

class PlyMeshReader {
 public:
  PlyMeshReader(std::string_view bytes, FilePlace& place) : bytes_(bytes), place_(place) {}

  TriangleMesh read() {
    const PlyHeader h = read_ply_header(bytes_, place_);
    const PlyElement &vertices = element(h, "vertex"), &faces = element(h, "face");
    for (int k = 0; k < 3; ++k) axis_[k] = axis(vertices, k);
    list_ = index_list(faces);
    if (faces.count == 0)
      fail("the mesh has no faces; export it with faces, or use shape = \"points\"");
    vertices_ = vertices.count;
    if (vertices.count > most_ply_items || faces.count > most_ply_items)
      fail(fmt::format("{} vertices and {} faces; the maximum is {} of each, use a coarser mesh",
                       vertices.count, faces.count, most_ply_items));
    PlyRows rows(bytes_, h.format, place_);
    const PlyElement* last = std::max(&vertices, &faces);
    for (const PlyElement* e = h.elements.data(); e <= last; ++e)
      if (e == &vertices) rows.read(*e, [&](const auto& row, auto k) { add_vertex(row, k); });
      else if (e == &faces) rows.read(*e, [&](const auto& row, auto k) { add_face(row, k); });
      else rows.skip(*e);
    place_.line = 0;
    remove_unused();
    return std::move(mesh_);
  }

 private:
  [[noreturn]] void fail(const std::string& why) const { place_.fail(why); }

  const PlyElement& element(const PlyHeader& h, const char* name) const {
    const auto named = [&](const PlyElement& e) { return e.name == name; };
    const auto it = std::find_if(h.elements.begin(), h.elements.end(), named);
    if (it == h.elements.end())
      fail(fmt::format("the header has no element \"{}\"; a mesh has vertices and faces", name));
    if (std::count_if(h.elements.begin(), h.elements.end(), named) > 1)
      fail(fmt::format("the header has the element \"{}\" twice; save the file again", name));
    return *it;
  }
  std::size_t axis(const PlyElement& vertices, int k) const {
    static constexpr const char* names[] = {"x", "y", "z"};
    const auto& all = vertices.properties;
    for (std::size_t p = 0; p < all.size(); ++p)
      if (all[p].name == names[k] && !all[p].is_list) return p;
    fail(fmt::format("the vertices have no {}; a mesh has x, y and z", names[k]));
  }
  std::size_t index_list(const PlyElement& faces) const {
    const auto& all = faces.properties;
    for (std::size_t p = 0; p < all.size(); ++p)
      if ((all[p].name == "vertex_indices" || all[p].name == "vertex_index") && all[p].is_list)
        return p;
    fail("the faces have no list vertex_indices or vertex_index; export the mesh again");
  }

  void add_vertex(const PlyRow& row, std::uint64_t k) {
    const TriangleMesh::Point x{row.values[axis_[0]], row.values[axis_[1]], row.values[axis_[2]]};
    for (const std::size_t axis : axis_)
      if (!(std::abs(row.values[axis]) <= farthest_corner))  // true for NaN as well
        fail(
            fmt::format("vertex {} has the coordinate {}; coordinates are finite, at most {:g}, "
                        "export the mesh again",
                        k, row.values[axis], farthest_corner));
    mesh_.points.push_back(x);
  }

  void add_face(const PlyRow& row, std::uint64_t k) {
    const std::vector<double>& corners = row.lists[list_];
    if (corners.size() < 3)
      fail(fmt::format("face {} has {} corners; the minimum is 3, export the mesh again", k,
                       corners.size()));
    for (const double corner : corners)
      if (!(corner >= 0 && corner < double(vertices_) && corner == std::floor(corner)))
        fail(
            fmt::format("face {} has the vertex {}, and there are {} vertices, from 0 on; export "
                        "the mesh again",
                        k, corner, vertices_));
    if (mesh_.triangles.size() + corners.size() > most_ply_items)
      fail(fmt::format("more than {} triangles; use a coarser mesh", most_ply_items));
    for (std::size_t c = 2; c < corners.size(); ++c)
      mesh_.triangles.push_back({int(corners[0]), int(corners[c - 1]), int(corners[c])});
  }

  void remove_unused() {
    std::vector<int> place(mesh_.points.size(), -1);
    std::vector<TriangleMesh::Point> used;
    for (TriangleMesh::Triangle& t : mesh_.triangles)
      for (int& corner : t) {
        int& to = place[std::size_t(corner)];
        if (to < 0) {
          to = int(used.size());
          used.push_back(mesh_.points[std::size_t(corner)]);
        }
        corner = to;
      }
    mesh_.points = std::move(used);
  }

  std::string_view bytes_;
  FilePlace& place_;
  std::size_t axis_[3] = {}, list_ = 0;  // properties of a vertex and of a face
  std::uint64_t vertices_ = 0;
  TriangleMesh mesh_;
};

}  // namespace

TriangleMesh read_ply_mesh(std::string_view bytes, FilePlace& place) {
  return PlyMeshReader(bytes, place).read();
}

}  // namespace freshet
