// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "import/mesh_solid.h"
#include "import/splishsplash.h"
#include "scene/sample/point_cloud.h"

namespace freshet {
namespace {

using SplishPoint = Vec<3, double>;

/// The velocity of a fluid that also turns about the centre of its particles.
void set_velocity(JsonObject& fluid, const SplishPoint& center, SplishWorld& world,
                  TomlTable& table) {
  const int dimension = world.dimension;
  const SplishPoint v = fluid.point("initialVelocity", {}),
                    w = fluid.point("initialAngularVelocity", {});
  world.fastest = std::max(world.fastest, norm(v));
  if (norm(w) == 0) {
    if (norm(v) > 0) table.set("velocity", v, dimension);
    return;
  }
  const SplishPoint at_origin = v - cross(w, center);
  const auto term = [](double factor, const char* name) {
    return fmt::format("{:+.9g}*{}", factor, name);
  };
  const std::string functions[] = {
      fmt::format("\"{:.9g}{}{}\"", at_origin.x, term(w.y, dimension == 3 ? "z" : "0"),
                  term(-w.z, "y")),
      fmt::format("\"{:.9g}{}{}\"", at_origin.y, term(w.z, "x"),
                  term(-w.x, dimension == 3 ? "z" : "0")),
      fmt::format("\"{:.9g}{}{}\"", at_origin.z, term(w.x, "y"), term(-w.y, "x"))};
  table.line("velocity_field", "[" + functions[0] + ", " + functions[1] +
                                   (dimension == 3 ? ", " + functions[2] : "") + "]");
}

void note_dense_mode(JsonObject& fluid) {
  if (fluid.integer("denseMode", 0, 0, 2) != 0)
    fluid.instead("denseMode", "a denser packing; taken instead: the regular lattice");
  fluid.display({"visMesh"});
}

/// The particles of a block, which begin a spacing behind its lower corner.
std::string read_block(JsonObject& block, const SplishMaterials& materials, SplishWorld& world) {
  Placement place;  // a block is not rotated
  place.translation = block.point("translation", {});
  place.scale = block.point("scale", {1, 1, 1});
  if (!block.has("start") || !block.has("end"))
    block.error("start", "and end are needed; set both corners of the block");
  const SplishPoint start = block.point("start", {}), end = block.point("end", {1, 1, 1});
  const SplishPoint low = place(start), size = place(end) - low;
  const double d = world.spacing();
  const std::string id = block.text("id", "Fluid");
  note_dense_mode(block);
  const double counts[] = {std::round(size.x / d) - 1, std::round(size.y / d) - 1,
                           std::round(size.z / d) - 1};
  TomlTable table;
  if (*std::min_element(counts, counts + 3) <= 1) {
    block.missing("start", "SPlisHSPlasH leaves out a block thinner than three particles");
    block.finish();
    return "";
  }
  const SplishPoint first = low + SplishPoint{d, d, d};
  const SplishPoint last = first + d * SplishPoint{counts[0] - 1, counts[1] - 1, counts[2] - 1};
  table.set("shape", "lattice");
  table.set("from", first, world.dimension);
  table.line("count", fmt::format("[{:.0f}, {:.0f}", counts[0], counts[1]) +
                          (world.flat() ? "]" : fmt::format(", {:.0f}]", counts[2])));
  const SplishPoint half{world.radius, world.radius, world.radius};
  world.extent.add(first - half);
  world.extent.add(last + half);
  set_velocity(block, 0.5 * (first + last), world, table);
  table.add(materials.liquid(id).of_fluid());
  block.finish();
  return table.item("fluid");
}

/// Reports the errors of a file at the key that names it.
template <class Read>
bool read_named_file(JsonObject& object, const char* key, const std::string& file, Read read) {
  try {
    read();
    return true;
  } catch (const Error& e) {
    object.error(key, fmt::format("is {}: {}", toml_string(file), e.diagnostics().front().message));
    return false;
  }
}

/// The bounds of the particles of a model.
Bounds bounds_of_model(const std::string& file, bool is_mesh, const Placement& place,
                       const SplishWorld& world) {
  Bounds bounds;
  if (is_mesh) {
    for (const SplishPoint& p : read_mesh(world.from / file).points) bounds.add(place(p));
    return bounds;
  }
  const std::vector<double> x = read_points(world.from / file, world.dimension).x;
  const auto n = std::size_t(world.dimension);
  for (std::size_t i = 0; i + n <= x.size(); i += n)
    bounds.add(place({x[i], x[i + 1], n == 3 ? x[i + 2] : 0}));
  return bounds;
}

std::string read_model(JsonObject& model, const SplishMaterials& materials, SplishWorld& world) {
  Placement place = read_splish_placement(model);
  place.scale = model.point("scale", {1, 1, 1});
  const std::string file = model.text("particleFile", ""), id = model.text("id", "Fluid");
  const bool is_mesh = is_mesh_file(file);
  note_dense_mode(model);
  if (model.boolean("invert", false))
    model.missing("invert", "the liquid fills the inside of the mesh");
  model.display({"resolutionSDF"});
  if (file.empty()) {
    model.error("particleFile", "is missing; name a file of points or a mesh");
    return "";
  }
  if (!is_mesh && !place.scales_evenly())
    model.instead("scale",
                  "SPlisHSPlasH scales points by the first number only, and so does the "
                  "conversion");
  if (!is_mesh) place.scale = {place.scale.x, place.scale.x, place.scale.x};
  if (!place.scales_evenly() || !(place.scale.x > 0)) {
    model.error("scale",
                "must be three equal numbers > 0 for this mesh; apply the scale to the "
                "file, for example in Blender");
    return "";
  }
  Bounds bounds;
  if (!read_named_file(model, "particleFile", file,
                       [&] { bounds = bounds_of_model(file, is_mesh, place, world); }))
    return "";
  TomlTable table;
  table.set("shape", is_mesh ? "mesh" : "points");
  table.set("file", world.file_in_toml(file));
  if (place.scale.x != 1) table.set("scale", place.scale.x);
  if (place.turned()) {
    const SplishPoint turn = place.degrees();
    if (world.flat()) table.set("rotation", turn.z);
    else table.set("rotation", turn, 3);
  }
  if (norm(place.translation) > 0) table.set("translation", place.translation, world.dimension);
  set_velocity(model, bounds.center(), world, table);
  table.add(materials.liquid(id).of_fluid());
  const SplishPoint half{world.radius, world.radius, world.radius};
  bounds.add(bounds.low - half);
  bounds.add(bounds.high + half);
  world.extent.add(bounds);
  model.finish();
  return table.item("fluid");
}

}  // namespace

bool is_mesh_file(const std::string& file) {
  std::string extension = std::filesystem::path(file).extension().string();
  std::transform(extension.begin(), extension.end(), extension.begin(),
                 [](unsigned char c) { return char(std::tolower(c)); });
  return extension == ".obj" || extension == ".ply";
}

std::string read_splish_fluids(std::vector<JsonObject> blocks, std::vector<JsonObject> models,
                               const SplishMaterials& materials, SplishWorld& world) {
  std::string tables;
  for (JsonObject& block : blocks) tables += read_block(block, materials, world);
  for (JsonObject& model : models) tables += read_model(model, materials, world);
  return tables;
}

}  // namespace freshet
