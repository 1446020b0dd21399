// SPDX-License-Identifier: MIT
#include "io/surface_files.h"

#include <fmt/format.h>

#include <bit>
#include <iterator>

#include "io/vtp_arrays.h"

namespace freshet {
namespace {

static_assert(std::endian::native == std::endian::little, "numbers are written as they stand");

template <class T> void append_bytes(std::string& bytes, const T& value) {
  bytes.append(reinterpret_cast<const char*>(&value), sizeof value);
}

struct MeshFormat {
  const char* extension;
  std::string (*encode)(const SurfaceMesh&, const SurfaceTime&);
};

/// In the order of SurfaceFormat.
constexpr MeshFormat mesh_formats[] = {{".ply", encode_surface_ply},
                                       {".obj", encode_surface_obj},
                                       {".vtp", encode_surface_vtp},
                                       {".glb", encode_surface_glb},
                                       {".vdb", nullptr}};

}  // namespace

std::string encode_surface_ply(const SurfaceMesh& mesh, const SurfaceTime& time) {
  const bool moves = !mesh.velocity.empty();
  std::string bytes = fmt::format(
      "ply\nformat binary_little_endian 1.0\ncomment time {}\ncomment step {}\n"
      "element vertex {}\n",
      time.time, time.step, mesh.position.size());
  for (const char* name : {"x", "y", "z", "nx", "ny", "nz"})
    bytes += fmt::format("property float {}\n", name);
  if (moves) bytes += "property float vx\nproperty float vy\nproperty float vz\n";
  bytes += fmt::format("element face {}\nproperty list uchar int vertex_indices\nend_header\n",
                       mesh.triangles.size());
  bytes.reserve(bytes.size() + 36 * mesh.position.size() + 13 * mesh.triangles.size());
  for (std::size_t k = 0; k < mesh.position.size(); ++k) {
    append_bytes(bytes, mesh.position[k]);
    append_bytes(bytes, mesh.normal[k]);
    if (moves) append_bytes(bytes, mesh.velocity[k]);
  }
  for (const auto& triangle : mesh.triangles) {
    append_bytes(bytes, std::uint8_t(3));
    append_bytes(bytes, triangle);
  }
  return bytes;
}

std::string encode_surface_obj(const SurfaceMesh& mesh, const SurfaceTime& time) {
  fmt::memory_buffer text;
  const auto out = std::back_inserter(text);
  fmt::format_to(out, "# time {} s, step {}\n", time.time, time.step);
  for (const auto& [x, y, z] : mesh.position) fmt::format_to(out, "v {} {} {}\n", x, y, z);
  for (const auto& [x, y, z] : mesh.normal)
    fmt::format_to(out, "vn {:.4f} {:.4f} {:.4f}\n", x, y, z);
  for (const auto& t : mesh.triangles)  // corners count from 1; each has the normal of its number
    fmt::format_to(out, "f {0}//{0} {1}//{1} {2}//{2}\n", std::uint64_t(t[0]) + 1,
                   std::uint64_t(t[1]) + 1, std::uint64_t(t[2]) + 1);
  return fmt::to_string(text);
}

std::string encode_surface_vtp(const SurfaceMesh& mesh, const SurfaceTime& time) {
  VtpArrays data;
  std::string text = vtp_start(time.time, time.step);
  text += fmt::format(
      "    </FieldData>\n"
      "    <Piece NumberOfPoints=\"{}\" NumberOfVerts=\"0\" NumberOfLines=\"0\" "
      "NumberOfStrips=\"0\" NumberOfPolys=\"{}\">\n"
      "      <PointData Normals=\"Normals\" Vectors=\"velocity\">\n",
      mesh.position.size(), mesh.triangles.size());
  text += data.array("Float32", "Normals", 3, mesh.normal);
  if (!mesh.velocity.empty()) text += data.array("Float32", "velocity", 3, mesh.velocity);
  text += "      </PointData>\n      <Points>\n" +
          data.array("Float32", "Points", 3, mesh.position) + "      </Points>\n      <Polys>\n";
  std::vector<std::int64_t> corners, ends;
  corners.reserve(3 * mesh.triangles.size());
  for (const auto& t : mesh.triangles) {
    corners.insert(corners.end(), t.begin(), t.end());
    ends.push_back(std::int64_t(corners.size()));
  }
  text += data.array("Int64", "connectivity", 1, corners);
  text += data.array("Int64", "offsets", 1, ends);
  return vtp_file(std::move(text) + "      </Polys>\n", data);
}

std::string encode_surface(SurfaceFormat format, const SurfaceMesh& mesh, const SurfaceTime& time) {
  return mesh_formats[int(format)].encode(mesh, time);
}

const char* extension_of(SurfaceFormat format) { return mesh_formats[int(format)].extension; }

}  // namespace freshet
