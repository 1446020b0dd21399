// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "import/splishsplash.h"

namespace freshet {
namespace {

using InletPoint = Vec<3, double>;

struct SplishEmitter {
  InletPoint center, direction, up;
  long width = 5, height = 5;
  bool round = false;
  std::string id;
};

SplishEmitter read_emitter_shape(JsonObject& o, const SplishWorld& world) {
  SplishEmitter e;
  Placement place = read_splish_placement(o);
  if (world.flat()) place.axis = {0, 0, 1};
  e.center = place.translation;
  e.direction = place.turn({1, 0, 0});
  for (int k = 0; k < 3; ++k)  // a rounded angle leaves a tilt that no one meant
    if (std::abs(component(e.direction, k)) < 1e-5) component(e.direction, k) = 0;
  e.up = place.turn({0, 1, 0});
  e.width = o.integer("width", 5, 1, 100000);
  e.height = o.integer("height", 5, 1, 100000);
  e.round = o.choice("type", 0, {"box", "circle"}) == 1;
  if (e.round) e.height = e.width;
  e.id = o.text("id", "Fluid");
  return e;
}

/// Moves an opening inwards until the layers that it holds are in the tank.
void move_into_tank(JsonObject& o, SplishEmitter& e, const SplishWorld& world) {
  if (!world.tank) return;
  const InletPoint asked = e.center;
  const double depth = 3.02 * world.spacing();
  for (int k = 0; k < world.dimension; ++k) {
    const double along = component(e.direction, k);
    Bounds tank = *world.tank;
    double& x = component(e.center, k);
    if (along > 0.3) x = std::max(x, component(tank.low, k) + depth * along);
    if (along < -0.3) x = std::min(x, component(tank.high, k) + depth * along);
  }
  if (norm(e.center - asked) > 0)
    o.instead("translation", fmt::format("the three layers behind an inlet must be in the tank; "
                                         "taken instead: {}",
                                         toml_vector(e.center, world.dimension)));
}

void set_opening(const SplishEmitter& e, const SplishWorld& world, TomlTable& table) {
  const double d = world.spacing();
  table.set("center", e.center, world.dimension);
  table.set("direction", e.direction, world.dimension);
  if (world.flat()) table.set("width", double(e.height) * d);
  else if (e.round) table.set("radius", 0.5 * double(e.width) * d);
  else {
    table.set("width", double(e.width) * d);
    table.set("height", double(e.height) * d);
    table.set("up", e.up, 3);
  }
}

/// Particles of a layer.
double layer_of(const SplishEmitter& e, const SplishWorld& world) {
  if (world.flat()) return double(e.height);
  const double square = double(e.width) * double(e.height);
  return e.round ? 0.785 * square : square;
}

void set_times(JsonObject& o, const SplishEmitter& e, double speed, const SplishLiquid& liquid,
               const SplishWorld& world, TomlTable& table) {
  const double start = o.number("emitStartTime", 0, {.min = 0});
  double stop = o.number("emitEndTime", 1e15, {.min = 0, .max = 1e300});
  if (!liquid.reuse) {
    const double layers = std::floor(double(liquid.max_particles) / layer_of(e, world));
    const double full = start + std::max(1.0, layers) * world.spacing() / speed;
    if (full < std::min(stop, world.duration)) {
      stop = full;
      o.assumed("emitEndTime", fmt::format("the emitter has {} particles (maxEmitterParticles), "
                                           "which last until then; taken instead: {:.4g} s",
                                           liquid.max_particles, stop));
    }
  }
  if (start > 0) table.set("start", start);
  if (stop < world.duration) table.set("stop", std::max(stop, start + 1e-6));
}

std::string read_emitter(JsonObject& o, const SplishMaterials& materials, SplishWorld& world) {
  SplishEmitter e = read_emitter_shape(o, world);
  move_into_tank(o, e, world);
  const SplishLiquid& liquid = materials.liquid(e.id);
  const double speed = o.number("velocity", 1, {.min = 0, .above = true});
  world.fastest = std::max(world.fastest, speed);
  TomlTable table;
  set_opening(e, world, table);
  table.set("speed", speed);
  set_times(o, e, speed, liquid, world, table);
  table.add(liquid.of_inlet());
  const double half = 0.5 * double(std::max(e.width, e.height)) * world.spacing();
  const InletPoint behind = e.center - 3.1 * world.spacing() * e.direction;
  for (const InletPoint& p : {e.center, behind}) {
    world.extent.add(p - InletPoint{half, half, half});
    world.extent.add(p + InletPoint{half, half, half});
  }
  o.display({"tag", "boundingBoxMin", "boundingBoxMax", "comment"});
  o.finish();
  return table.item("inlet");
}

/// Where particles that emitters use again disappear.
std::string outlet_of(const SplishLiquid& liquid, const SplishWorld& world) {
  const Bounds& box = liquid.reuse_box;
  const Bounds& all = world.tank ? *world.tank : world.extent;
  const bool cuts = box.low.x > all.low.x || box.low.y > all.low.y || box.high.x < all.high.x ||
                    box.high.y < all.high.y ||
                    (!world.flat() && (box.low.z > all.low.z || box.high.z < all.high.z));
  if (!liquid.reuse || !cuts) return "";
  TomlTable table;
  table.set("side", "outside");
  table.set("min", box.low, world.dimension);
  table.set("max", box.high, world.dimension);
  return table.item("outlet");
}

}  // namespace

std::string read_splish_emitters(std::vector<JsonObject> emitters, const SplishMaterials& materials,
                                 SplishWorld& world) {
  std::string tables;
  for (JsonObject& o : emitters) tables += read_emitter(o, materials, world);
  std::set<std::string> outlets;
  for (JsonObject& o : emitters)
    outlets.insert(outlet_of(materials.liquid(o.text("id", "Fluid")), world));
  for (const std::string& outlet : outlets) tables += outlet;
  return tables;
}

}  // namespace freshet
