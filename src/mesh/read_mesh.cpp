// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cctype>
#include <cmath>
#include <iterator>
#include <string>

#include "core/input_file.h"
#include "mesh/mesh_formats.h"

#ifdef FRESHET_ASSIMP
#include <assimp/postprocess.h>
#include <assimp/scene.h>
#include <assimp/Importer.hpp>
#endif

namespace freshet {
namespace {

std::string extension_of(const std::filesystem::path& file) {
  std::string extension = file.extension().string();
  for (char& c : extension) c = char(std::tolower(static_cast<unsigned char>(c)));
  return extension;
}

#ifdef FRESHET_ASSIMP

void append(const aiMesh& part, TriangleMesh& mesh, const FilePlace& place) {
  const int first = int(mesh.points.size());
  for (unsigned k = 0; k < part.mNumVertices; ++k) {
    const aiVector3D& v = part.mVertices[k];
    for (const float x : {v.x, v.y, v.z})
      if (!(std::abs(double(x)) <= farthest_corner))  // true for NaN as well
        place.fail("a corner is not finite, or beyond 1e15; export the mesh again");
    mesh.points.push_back({double(v.x), double(v.y), double(v.z)});
  }
  for (unsigned k = 0; k < part.mNumFaces; ++k) {
    const aiFace& face = part.mFaces[k];
    if (face.mNumIndices == 3)
      mesh.triangles.push_back({first + int(face.mIndices[0]), first + int(face.mIndices[1]),
                                first + int(face.mIndices[2])});
  }
}

/// Reads bytes that have been checked. `format` is "obj" or "stl". Assimp opens no file.
TriangleMesh read_by_assimp(std::string_view bytes, const char* format, const FilePlace& place) {
  Assimp::Importer importer;
  const aiScene* scene = importer.ReadFileFromMemory(
      bytes.data(), bytes.size(), aiProcess_Triangulate | aiProcess_PreTransformVertices, format);
  if (!scene)
    place.fail("not a valid mesh (" + std::string(importer.GetErrorString()).substr(0, 200) +
               "); export it again");
  TriangleMesh mesh;
  for (unsigned k = 0; k < scene->mNumMeshes; ++k) append(*scene->mMeshes[k], mesh, place);
  return mesh;
}

#else

TriangleMesh read_by_assimp(std::string_view, const char*, const FilePlace& place) {
  place.fail(
      "this build reads no *.stl and no *.obj, as Assimp was missing; convert the mesh to *.ply, "
      "or install libassimp-dev and build again");
}

#endif

TriangleMesh read_obj_mesh(std::string_view bytes, FilePlace& place) {
  return read_by_assimp(plain_obj(bytes, place), "obj", place);
}

TriangleMesh read_stl_mesh(std::string_view bytes, FilePlace& place) {
  check_stl(bytes, place);
  return read_by_assimp(bytes, "stl", place);
}

constexpr struct {
  const char* extension;
  TriangleMesh (*read)(std::string_view bytes, FilePlace& place);
} mesh_formats[] = {{".stl", read_stl_mesh}, {".obj", read_obj_mesh}, {".ply", read_ply_mesh}};

}  // namespace

#ifdef FRESHET_ASSIMP
bool reads_meshes() { return true; }
#else
bool reads_meshes() { return false; }
#endif

TriangleMesh mesh_in(std::string_view bytes, const std::filesystem::path& file) {
  FilePlace place(file.string());
  const std::string extension = extension_of(file);
  const auto format = std::find_if(std::begin(mesh_formats), std::end(mesh_formats),
                                   [&](const auto& f) { return extension == f.extension; });
  if (format == std::end(mesh_formats))
    place.fail("not a known format of meshes (*.stl, *.obj or *.ply); export it as one of them");
  TriangleMesh mesh = format->read(bytes, place);
  if (mesh.triangles.empty()) place.fail("the mesh has no triangles; export it again");
  return mesh;
}

TriangleMesh read_mesh(const std::filesystem::path& file) {
  constexpr InputFile mesh_file{.noun = "mesh file", .remedy = "name a *.stl, *.obj or *.ply file"};
  return mesh_in(read_input(file, mesh_file), file);
}

}  // namespace freshet
