// SPDX-License-Identifier: MIT
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <nlohmann/json.hpp>

#include "io/surface_files.h"

namespace freshet {
namespace {

// Constants of glTF 2.0.
constexpr int float_type = 5126, index_type = 5125;         // componentType
constexpr int vertex_buffer = 34962, index_buffer = 34963;  // target
constexpr std::uint32_t glb_magic = 0x46546C67, json_chunk = 0x4E4F534A, binary_chunk = 0x004E4942;

void append_word(std::string& bytes, std::uint32_t value) {
  bytes.append(reinterpret_cast<const char*>(&value), sizeof value);
}

/// Appends a chunk, padded to a multiple of four bytes.
void append_chunk(std::string& file, std::uint32_t type, std::string bytes) {
  bytes.resize((bytes.size() + 3) / 4 * 4, type == json_chunk ? ' ' : '\0');
  append_word(file, std::uint32_t(bytes.size()));
  append_word(file, type);
  file += bytes;
}

/// A glTF document and its buffer.
class GltfDocument {
 public:
  /// Appends an array and returns the number of its accessor.
  template <class T>
  std::size_t add(const std::vector<T>& values, int component, const char* type,
                  std::size_t components, int target) {
    const std::size_t bytes = values.size() * sizeof(T);
    json_["bufferViews"].push_back(
        {{"buffer", 0}, {"byteOffset", buffer_.size()}, {"byteLength", bytes}, {"target", target}});
    buffer_.append(reinterpret_cast<const char*>(values.data()), bytes);
    nlohmann::json& accessors = json_["accessors"];
    accessors.push_back({{"bufferView", accessors.size()},
                         {"componentType", component},
                         {"count", values.size() * sizeof(T) / 4 / components},
                         {"type", type}});
    return accessors.size() - 1;
  }
  std::size_t add_vectors(const std::vector<SurfaceMesh::Point>& values) {
    return add(values, float_type, "VEC3", 3, vertex_buffer);
  }
  /// The range of the positions, which the format requires.
  void add_bounds(std::size_t accessor, const std::vector<SurfaceMesh::Point>& values) {
    SurfaceMesh::Point low = values.front(), high = low;
    for (const SurfaceMesh::Point& p : values)
      for (std::size_t k = 0; k < 3; ++k) {
        low[k] = std::min(low[k], p[k]);
        high[k] = std::max(high[k], p[k]);
      }
    json_["accessors"][accessor]["min"] = low;
    json_["accessors"][accessor]["max"] = high;
  }
  nlohmann::json& json() { return json_; }

  std::string file() {
    if (!buffer_.empty())
      json_["buffers"] = nlohmann::json::array({{{"byteLength", buffer_.size()}}});
    std::string chunks;
    if (buffer_.size() < largest) {
      append_chunk(chunks, json_chunk, json_.dump());
      if (!buffer_.empty()) append_chunk(chunks, binary_chunk, std::move(buffer_));
    }
    if (chunks.empty() || chunks.size() > largest)
      throw Error(Error::Kind::run, "",
                  "the surface is too large for a *.glb file, which has at most 4 GiB; choose "
                  "another `format` or a larger `cell`",
                  {"format", "cell"});
    std::string file;
    for (const std::uint32_t word : {glb_magic, 2u, std::uint32_t(chunks.size() + 12)})
      append_word(file, word);
    return file + chunks;
  }

 private:
  static constexpr std::size_t largest = std::numeric_limits<std::uint32_t>::max() - 12;
  nlohmann::json json_;
  std::string buffer_;
};

nlohmann::json material_of(const std::string& name, const std::array<float, 3>& linear_color,
                           float roughness) {
  return {{"name", name},
          {"pbrMetallicRoughness",
           {{"baseColorFactor", {linear_color[0], linear_color[1], linear_color[2], 1}},
            {"metallicFactor", 0},
            {"roughnessFactor", roughness}}}};
}

/// A file with one mesh of this material. `extras` are values about the file.
std::string encode_glb(const SurfaceMesh& mesh, const nlohmann::json& extras,
                       const std::string& name, const nlohmann::json& material) {
  GltfDocument document;
  nlohmann::json& json = document.json();
  json["asset"] = {{"version", "2.0"}, {"generator", "freshet"}};
  if (!extras.empty()) json["asset"]["extras"] = extras;
  json["scene"] = 0;
  json["scenes"] = nlohmann::json::array({nlohmann::json::object()});
  if (mesh.triangles.empty()) return document.file();
  nlohmann::json attributes;
  attributes["POSITION"] = document.add_vectors(mesh.position);
  document.add_bounds(attributes["POSITION"], mesh.position);
  attributes["NORMAL"] = document.add_vectors(mesh.normal);
  if (!mesh.velocity.empty()) attributes["_VELOCITY"] = document.add_vectors(mesh.velocity);
  const std::size_t indices = document.add(mesh.triangles, index_type, "SCALAR", 1, index_buffer);
  json["scenes"][0]["nodes"] = nlohmann::json::array({0});
  json["nodes"] = nlohmann::json::array({{{"name", name}, {"mesh", 0}}});
  json["materials"] = nlohmann::json::array({material});
  const nlohmann::json triangles{{"attributes", attributes}, {"indices", indices}, {"material", 0}};
  json["meshes"] = nlohmann::json::array();
  json["meshes"].push_back({{"primitives", nlohmann::json::array({triangles})}});
  return document.file();
}

float linear_of(float srgb) {
  return srgb <= 0.04045f ? srgb / 12.92f : std::pow((srgb + 0.055f) / 1.055f, 2.4f);
}

}  // namespace

std::string encode_surface_glb(const SurfaceMesh& mesh, const SurfaceTime& time) {
  return encode_glb(mesh, {{"time", time.time}, {"step", time.step}}, "surface",
                    material_of("water", {0.05f, 0.25f, 0.4f}, 0.05f));
}

std::string encode_solid_glb(const SurfaceMesh& mesh, const SolidMaterial& material) {
  const auto& [r, g, b] = material.color;
  return encode_glb(
      mesh, {}, material.name,
      material_of(material.name, {linear_of(r), linear_of(g), linear_of(b)}, material.roughness));
}

}  // namespace freshet
