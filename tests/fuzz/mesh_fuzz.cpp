// SPDX-License-Identifier: MIT
/// Any bytes give a mesh or an Error. The first byte is the format: p, s or o for PLY, STL or OBJ.
/// The file follows.
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <string_view>

#include "freshet/error.h"
#include "mesh/triangle_mesh.h"

namespace {

void require(bool good, const char* what) {
  if (good) return;
  std::fprintf(stderr, "%s\n", what);
  std::abort();
}

void check_error(const freshet::Error& e) {
  require(e.kind() == freshet::Error::Kind::scene, "the error is not of kind scene");
  require(e.diagnostics().size() == 1, "there must be one diagnostic");
  require(e.diagnostics()[0].place.starts_with("fuzz."), "the diagnostic does not name the file");
  require(e.diagnostics()[0].message.size() < 300, "the message has 300 characters or more");
}

void check_mesh(const freshet::TriangleMesh& mesh) {
  require(!mesh.triangles.empty(), "the mesh has no triangle");
  for (const auto& triangle : mesh.triangles)
    for (const int corner : triangle)
      require(corner >= 0 && std::size_t(corner) < mesh.points.size(), "a corner is out of range");
  for (const auto& x : mesh.points)
    require(std::isfinite(x.x) && std::isfinite(x.y) && std::isfinite(x.z),
            "a point is not finite");
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  if (size == 0) return 0;
  const std::string_view bytes(reinterpret_cast<const char*>(data) + 1, size - 1);
  const char* file = data[0] == 'p' ? "fuzz.ply" : data[0] == 's' ? "fuzz.stl" : "fuzz.obj";
  if (data[0] != 'p' && data[0] != 's' && data[0] != 'o') return 0;
  try {
    freshet::TriangleMesh mesh = freshet::mesh_in(bytes, file);
    check_mesh(mesh);
    freshet::mend_mesh(mesh, 0.1);
    if (!mesh.triangles.empty()) check_mesh(mesh);
  } catch (const freshet::Error& e) {
    check_error(e);
  }
  return 0;
}
