// SPDX-License-Identifier: MIT
#pragma once
#include "freshet/scene.h"
#include "mesh/triangle_mesh.h"

namespace freshet {

/// The surface of a body in 3D at the start. Round surfaces consist of small triangles.
TriangleMesh body_mesh(const Scene::Body& body);

/// The surface of a body as a collider needs it: in 2D, a prism over its outline.
TriangleMesh collision_mesh(const Scene::Body& body);

/// A surface as a Wavefront OBJ file, about the point `origin`.
std::string encode_obj(const TriangleMesh& mesh, TriangleMesh::Point origin,
                       const std::string& name);

}  // namespace freshet
