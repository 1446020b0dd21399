// SPDX-License-Identifier: MIT
/// The formats of mesh files. All functions call `place.fail` if the bytes are not a valid mesh.
#pragma once
#include <string>
#include <string_view>

#include "formats/file_place.h"
#include "mesh/triangle_mesh.h"

namespace freshet {

inline constexpr double farthest_corner = 1e15;     ///< maximum coordinate
inline constexpr std::size_t most_corners = 10000;  ///< of a polygon

/// Reads the vertices and faces of a PLY file: ascii, or binary of either byte order. Polygons are
/// split into fans of triangles. Vertices without a face are removed.
TriangleMesh read_ply_mesh(std::string_view bytes, FilePlace& place);

/// The vertices and faces of an OBJ file as an OBJ file without anything else: no normals, no
/// materials and no names of other files. All corners are in range.
std::string plain_obj(std::string_view bytes, FilePlace& place);

/// Checks an STL file before another library reads it. The size of a binary file must be that of
/// its triangles; every facet of an ascii file must have three vertices.
void check_stl(std::string_view bytes, FilePlace& place);

}  // namespace freshet
