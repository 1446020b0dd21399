// SPDX-License-Identifier: MIT
#include "import/splishsplash.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "core/input_file.h"
#include "import/parse_json.h"

namespace freshet {
namespace {

namespace fs = std::filesystem;

/// The ids that the scene uses, in the order of their first block, model or emitter.
std::vector<std::string> used_ids(JsonObject& scene) {
  std::vector<std::string> ids;
  for (const char* list : {"FluidBlocks", "FluidModels", "Emitters"})
    for (JsonObject& o : scene.list(list))
      if (const std::string id = o.text("id", "Fluid");
          std::find(ids.begin(), ids.end(), id) == ids.end())
        ids.push_back(id);
  return ids;
}

/// The box of the scene: the tank, or a room around everything whose sides are open.
TomlTable domain_of(const SplishWorld& world, const Vec<3, double>& gravity) {
  Bounds room = world.extent;
  if (world.tank) {
    room = *world.tank;
  } else {
    if (room.empty()) {
      room.add(Vec<3, double>{0, 0, 0});
      room.add(Vec<3, double>{1, 1, 1});
    }
    const Vec<3, double> size = room.size();
    const double beyond = std::max({1.0, size.x / 2, size.y / 2, world.flat() ? 0 : size.z / 2});
    room.low = room.low - Vec<3, double>{beyond, beyond, beyond};
    room.high = room.high + Vec<3, double>{beyond, beyond, beyond};
  }
  TomlTable table;
  table.set("min", room.low, world.dimension);
  table.set("max", room.high, world.dimension);
  table.set("gravity", gravity, world.dimension);
  return table;
}

/// Whether all fluid is files of points.
bool has_only_points(JsonObject& scene) {
  if (!scene.list("FluidBlocks").empty() || !scene.list("Emitters").empty()) return false;
  std::vector<JsonObject> models = scene.list("FluidModels");
  return !models.empty() && std::all_of(models.begin(), models.end(), [](JsonObject& model) {
    return !is_mesh_file(model.text("particleFile", ""));
  });
}

/// The speed of sound, from the pressure k ((rho/rho0)^n - 1) of WCSPH. A liquid that moves faster
/// than its sound has no step that is stable.
void set_sound_speed(const SplishSettings& settings, const std::vector<std::string>& ids,
                     const SplishMaterials& materials, const SplishWorld& world,
                     TomlTable& solver) {
  JsonObject block = *settings.wcsph;
  const double density = materials.liquid(ids.empty() ? "" : ids.front()).rest_density;
  const double sound = std::sqrt(settings.bulk_modulus / density);
  const double fall = world.tank ? std::sqrt(2 * norm(settings.gravity) * world.tank->size().y) : 0;
  const double flow = std::max(world.fastest, fall);
  if (sound > flow) {
    solver.set("sound_speed", sound);
    return;
  }
  block.assumed("stiffness",
                fmt::format("sound of {:.3g} m/s is slower than the flow, which may reach {:.3g} "
                            "m/s; taken instead: the default of solver.sound_speed",
                            sound, flow));
}

void read_fields(JsonObject& scene) {
  for (JsonObject& field : scene.list("AnimationFields"))
    field.missing("particleField",
                  fmt::format("a field that sets the {} of particles has no "
                              "counterpart; domain.body_force accelerates them, "
                              "and Python can move them (docs/python.md)",
                              in_one_line(field.text("particleField", "velocity"))));
}

}  // namespace

std::string SplishWorld::file_in_toml(const std::string& file) const {
  return path_for_toml(file, from, to);
}

Placement read_splish_placement(JsonObject& object) {
  Placement place;
  place.translation = object.point("translation", {});
  place.axis = object.point("rotationAxis", {0, 0, 1});
  place.angle = object.number("rotationAngle", 0);
  return place;
}

ImportedScene import_splishsplash(const std::string& json, const fs::path& file,
                                  const fs::path& folder) {
  const nlohmann::json parsed = parse_json(json, file.string());
  JsonFindings findings(json, file.string());
  JsonObject scene(&parsed, "", findings);
  SplishWorld world;
  world.from = file.parent_path();
  world.to = folder;
  world.only_points = has_only_points(scene);
  const SplishSettings settings = read_splish_settings(scene.object("Configuration"), world);
  const std::vector<std::string> ids = used_ids(scene);
  world.has_fluid = !scene.list("FluidBlocks").empty() || !scene.list("FluidModels").empty();
  const SplishMaterials materials = read_splish_materials(scene.list("Materials"), ids, world);
  const std::string bodies = read_splish_bodies(scene, materials.sticks, world);
  const std::string fluids =
      read_splish_fluids(scene.list("FluidBlocks"), scene.list("FluidModels"), materials, world);
  const std::string inlets = read_splish_emitters(scene.list("Emitters"), materials, world);
  read_fields(scene);
  scene.finish();
  findings.throw_errors();

  TomlTable title, walls, solver = settings.solver;
  title.set("title", file.stem().string());
  if (!world.tank) walls.set("method", "open");
  else if (!materials.sticks) walls.set("slip", "free_slip");
  if (settings.method != 0) solver.set("xsph", materials.xsph);
  else set_sound_speed(settings, ids, materials, world, solver);
  solver.add(materials.solver);
  ImportedScene result;
  result.notes = std::move(findings.notes);
  result.toml = comments_of(file.filename().string(), "SPlisHSPlasH", result.notes) + "\n";
  result.toml += title.lines() + domain_of(world, settings.gravity).table("domain") +
                 settings.particles.table("particles") + fluids + bodies + inlets +
                 solver.table("solver") + materials.air.table("air") + walls.table("walls") +
                 settings.time.table("time") + settings.output.table("output") +
                 materials.picture.table("picture") + settings.camera.table("camera");
  return result;
}

ImportedScene import_splishsplash(const fs::path& file, const fs::path& folder) {
  constexpr InputFile rules{.noun = "scene file",
                            .remedy = "name a scene file (*.json)",
                            .may_be_empty = true,
                            .largest = 16u << 20};
  return import_splishsplash(read_input(file, rules), file, folder);
}

}  // namespace freshet
