// SPDX-License-Identifier: MIT
/// Surfaces in the mesh formats of other programs. Binary data is little-endian.
#pragma once
#include <cstdint>
#include <string>

#include "freshet/surface.h"

namespace freshet {

/// The moment that a surface shows.
struct SurfaceTime {
  double time = 0;  ///< [s]
  std::int64_t step = 0;
};

/// Binary PLY: x, y, z, nx, ny, nz, vx, vy, vz as float; faces as lists of three int indices.
/// Comments: time [s], step. Velocities are skipped here and below if the mesh has none.
std::string encode_surface_ply(const SurfaceMesh& mesh, const SurfaceTime& time);
/// Wavefront OBJ: v, vn and f. The format has no place for velocities.
std::string encode_surface_obj(const SurfaceMesh& mesh, const SurfaceTime& time);
/// VTK XML PolyData: polygons, and the point arrays Normals and velocity, in raw appended data.
std::string encode_surface_vtp(const SurfaceMesh& mesh, const SurfaceTime& time);
/// glTF 2.0 in one binary file: one mesh with POSITION, NORMAL, _VELOCITY and 32-bit indices, and a
/// material like water. A mesh without triangles gives a scene without a mesh. Throws Error (kind
/// run) if the file would be longer than the format's 4 GiB.
std::string encode_surface_glb(const SurfaceMesh& mesh, const SurfaceTime& time);

/// A matte material.
struct SolidMaterial {
  std::string name;
  std::array<float, 3> color;  ///< sRGB, 0 to 1
  float roughness;             ///< 0 to 1
};
/// The surface of a solid as glTF 2.0, by the layout of encode_surface_glb.
std::string encode_solid_glb(const SurfaceMesh& mesh, const SolidMaterial& material);

/// In one of the formats of meshes, which are all but VDB.
std::string encode_surface(SurfaceFormat format, const SurfaceMesh& mesh, const SurfaceTime& time);
/// Such as ".ply".
const char* extension_of(SurfaceFormat format);

}  // namespace freshet
