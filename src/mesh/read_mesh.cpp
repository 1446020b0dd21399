// SPDX-License-Identifier: MIT
#include "mesh/triangle_mesh.h"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <string>

#include "freshet/error.h"

#ifdef FRESHET_ASSIMP
#include <assimp/postprocess.h>
#include <assimp/scene.h>
#include <assimp/Importer.hpp>
#endif

namespace freshet {

#ifdef FRESHET_ASSIMP

namespace {

[[noreturn]] void fail(const std::filesystem::path& file, const std::string& why) {
  throw Error(Error::Kind::scene, file.string(), why);
}

void check_file(const std::filesystem::path& file) {
  std::error_code ec;
  const auto status = std::filesystem::status(file, ec);
  if (!std::filesystem::exists(status)) fail(file, "no such file of a mesh; check the path");
  if (!std::filesystem::is_regular_file(status))
    fail(file, "not a file; name a *.stl, *.obj or *.ply file");
  std::string extension = file.extension().string();
  for (char& c : extension) c = char(std::tolower(static_cast<unsigned char>(c)));
  if (extension != ".stl" && extension != ".obj" && extension != ".ply")
    fail(file, "not *.stl, *.obj or *.ply; convert it to one");
}

void append(const aiMesh& part, TriangleMesh& mesh, const std::filesystem::path& file) {
  const int first = int(mesh.points.size());
  for (unsigned k = 0; k < part.mNumVertices; ++k) {
    const aiVector3D& v = part.mVertices[k];
    if (!std::isfinite(v.x) || !std::isfinite(v.y) || !std::isfinite(v.z))
      fail(file, "a corner is not finite; export the mesh again");
    mesh.points.push_back({double(v.x), double(v.y), double(v.z)});
  }
  for (unsigned k = 0; k < part.mNumFaces; ++k) {
    const aiFace& face = part.mFaces[k];
    if (face.mNumIndices == 3)
      mesh.triangles.push_back({first + int(face.mIndices[0]), first + int(face.mIndices[1]),
                                first + int(face.mIndices[2])});
  }
}

}  // namespace

bool reads_meshes() { return true; }

TriangleMesh read_mesh(const std::filesystem::path& file) {
  check_file(file);
  Assimp::Importer importer;
  const aiScene* scene =
      importer.ReadFile(file.string(), aiProcess_Triangulate | aiProcess_PreTransformVertices);
  if (!scene)
    fail(file,
         "cannot be read as a mesh (" + std::string(importer.GetErrorString()) + "); is it whole?");
  TriangleMesh mesh;
  for (unsigned k = 0; k < scene->mNumMeshes; ++k) append(*scene->mMeshes[k], mesh, file);
  if (mesh.triangles.empty()) fail(file, "there is no triangle in it; is it the right file?");
  return mesh;
}

#else

bool reads_meshes() { return false; }

TriangleMesh read_mesh(const std::filesystem::path& file) {
  throw Error(Error::Kind::scene, file.string(),
              "this Freshet was built without Assimp, which reads meshes; install libassimp-dev "
              "and build it anew");
}

#endif

}  // namespace freshet
