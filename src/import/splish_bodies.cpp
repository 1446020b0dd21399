// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <algorithm>
#include <numbers>

#include "import/mesh_solid.h"
#include "import/splishsplash.h"

namespace freshet {
namespace {

using BodyPoint = Vec<3, double>;

/// A body, with the joint that moves it.
struct SplishBody {
  JsonObject object;
  Placement place;
  std::string file, name;
  long id = -1;
  bool dynamic = false, animated = false, wall = false, inside = false;
  JsonObject* motor = nullptr;  ///< turns it about an axis that stands
  double motor_sign = 1;        ///< of the body's speed at a target speed above 0

  bool stands() const { return !dynamic && !motor && !animated; }
};

SplishBody read_body(JsonObject object, std::size_t k, const SplishWorld& world) {
  SplishBody b{object, {}, {}, {}};
  JsonObject& o = b.object;
  b.place = read_splish_placement(o);
  b.place.scale = o.point("scale", {1, 1, 1});
  b.file = o.text("geometryFile", "");
  b.id = o.integer("id", -1, -1000000000, 1000000000);
  b.name = fmt::format("body_{}", b.id >= 0 ? b.id : long(k));
  b.dynamic = o.boolean("isDynamic", false);
  b.animated = o.boolean("isAnimated", false);
  b.wall = o.boolean("isWall", false);
  const bool inverted = o.boolean("mapInvert", false);
  // Boundary particles have no inside: a wall of the scene is what holds the fluid.
  b.inside = inverted || (world.particle_walls && b.wall && !b.dynamic);
  o.display({"color", "mapResolution", "mapFile", "samplingMode", "invertSDF", "testMesh", "tag",
             "boundingBoxMin", "boundingBoxMax", "resolutionSDF"});
  if (o.number("mapThickness", 0) != 0)
    o.missing("mapThickness", "the surface is that of the mesh");
  o.missing("particleFile", "the surface of geometryFile is sampled instead");
  if (b.animated)
    o.instead("isAnimated",
              "a script moves it in SPlisHSPlasH; taken instead: it stands; set "
              "body.position or body.angle");
  o.missing("collisionObjectType", "contacts are those of the shape");
  o.display({"collisionObjectScale"});
  return b;
}

void set_slip(bool sticks, TomlTable& table) {
  if (!sticks) table.set("slip", "free_slip");
}

void set_turn(const SplishBody& b, const SplishWorld& world, TomlTable& table) {
  if (!b.place.turned()) return;
  const BodyPoint degrees = b.place.degrees();
  if (world.flat()) table.set("rotation", degrees.z);
  else table.set("rotation", degrees, 3);
}

/// The shape of a body: box, sphere, cylinder or mesh. In 2D a section may have several parts.
std::vector<TomlTable> shapes_of(SplishBody& b, const TriangleMesh& mesh, const MeshSolid& solid,
                                 const SplishWorld& world) {
  using Kind = MeshSolid::Kind;
  const BodyPoint center = b.place.turn(solid.bounds.center()) + b.place.translation;
  TomlTable table;
  if (solid.kind == Kind::box) {
    const BodyPoint half = 0.5 * solid.bounds.size();
    table.set("shape", "box");
    table.set("min", center - half, world.dimension);
    table.set("max", center + half, world.dimension);
    set_turn(b, world, table);
    return {table};
  }
  if (solid.kind == Kind::sphere) {
    table.set("shape", "sphere");
    table.set("center", center, world.dimension);
    table.set("radius", solid.radius);
    return {table};
  }
  if (world.flat()) {
    std::vector<TomlTable> parts;
    for (const auto& loop : section_of_mesh(mesh, b.place, world.radius)) {
      std::string points;
      for (const BodyPoint& p : loop)
        points += (points.empty() ? "[" : ", [") + toml_number(p.x) + ", " + toml_number(p.y) + "]";
      TomlTable part;
      part.set("shape", "polygon");
      part.line("points", "[" + points + "]");
      parts.push_back(part);
    }
    if (parts.empty()) b.object.missing("geometryFile", "the mesh does not meet the plane z = 0");
    return parts;
  }
  if (solid.kind == Kind::cylinder) {
    table.set("shape", "cylinder");
    table.set("center", center, 3);
    table.set("radius", solid.radius);
    table.set("length", solid.bounds.size().y);
    if (b.place.turned()) table.set("axis", b.place.turn({0, 1, 0}), 3);
    return {table};
  }
  if (!b.place.scales_evenly() || !(b.place.scale.x > 0)) {
    b.object.error("scale",
                   "must be three equal numbers > 0 for this mesh; apply the scale to the "
                   "file, for example in Blender");
    return {};
  }
  table.set("shape", "mesh");
  table.set("file", world.file_in_toml(b.file));
  if (b.place.scale.x != 1) table.set("scale", b.place.scale.x);
  set_turn(b, world, table);
  if (norm(b.place.translation) > 0) table.set("translation", b.place.translation, 3);
  return {table};
}

/// Key frames of a motor whose target speed is linear between the points of a sequence.
std::string motor_keys(JsonObject& motor, double sign, double duration, TomlTable& body) {
  const std::vector<double> sequence = motor.numbers("targetSequence");
  const bool repeats = motor.boolean("repeatSequence", false);
  const std::size_t n = sequence.size() / 2;
  bool rises = n >= 2 && sequence.size() % 2 == 0 && sequence[0] == 0;
  for (std::size_t k = 1; rises && k < n; ++k) rises = sequence[2 * k] > sequence[2 * k - 2];
  if (!rises) {
    motor.error("targetSequence",
                "must be times and speeds in turn, such as [0, -5, 1, 5], with "
                "rising times from 0");
    return "";
  }
  constexpr int parts = 20;  // key frames of an interval
  constexpr double most_keys = 100000;
  const double period = sequence[2 * n - 2];
  if (duration / period * double(n * parts) > most_keys) {
    motor.error("targetSequence", "repeats too often for key frames; make its times longer");
    return "";
  }
  std::string keys;
  double angle = 0, begin = 0;
  const auto add = [&](double time) {
    TomlTable key;
    key.set("time", time);
    key.set("angle", sign * angle * 180 / std::numbers::pi);
    keys += key.item("body.key");
  };
  add(0);
  for (; begin < duration; begin += period) {
    for (std::size_t k = 0; k + 1 < n; ++k) {
      const double t0 = sequence[2 * k], v0 = sequence[2 * k + 1], t1 = sequence[2 * k + 2],
                   slope = (sequence[2 * k + 3] - v0) / (t1 - t0);
      const double at_start = angle;
      for (int part = 1; part <= parts; ++part) {
        const double s = (t1 - t0) * part / parts;
        angle = at_start + s * v0 + 0.5 * slope * s * s;
        add(begin + t0 + s);
      }
    }
    if (!repeats) break;
  }
  if (!repeats && period < duration) {  // the last speed stays
    angle += (duration - period) * sequence[2 * n - 1];
    add(duration);
  }
  body.set("interpolation", "linear");
  return keys;
}

/// What moves a body, after its shape. Returns its key frames.
std::string set_motion(SplishBody& b, double duration, const SplishWorld& world, TomlTable& table) {
  JsonObject& o = b.object;
  if (b.motor) {
    table.set("motion", "moved");
    if (!world.flat()) table.set("turn_axis", b.motor->point("axis", {0, 0, 1}), 3);
    table.set("pivot", b.motor->point("position", {}), world.dimension);
    if (b.motor->has("targetSequence")) return motor_keys(*b.motor, b.motor_sign, duration, table);
    table.set("angle", fmt::format("{:.9g}*t", b.motor_sign * b.motor->number("target", 0) * 180 /
                                                   std::numbers::pi));
  } else if (b.dynamic) {
    table.set("motion", "free");
    table.set("density", o.number("density", 1000, {.min = 0, .above = true}));
    const BodyPoint v = o.point("velocity", {});
    if (norm(v) > 0) table.set("velocity", v, world.dimension);
    table.set("restitution", o.number("restitution", 0.6, {.min = 0, .max = 1}));
    table.set("friction", o.number("friction", 0.2, {.min = 0, .max = 10}));
  }
  return "";
}

/// Whether the body became the domain.
bool becomes_tank(const SplishBody& b, const MeshSolid& solid, SplishWorld& world) {
  if (solid.kind != MeshSolid::Kind::box || !b.inside || !b.stands() || b.place.turned() ||
      world.tank)
    return false;
  world.tank =
      Bounds{solid.bounds.low + b.place.translation, solid.bounds.high + b.place.translation};
  return true;
}

std::string write_body(SplishBody& b, bool sticks, SplishWorld& world) {
  if (b.file.empty()) {
    b.object.missing("geometryFile", "a body without geometryFile is left out");
    return "";
  }
  TriangleMesh mesh;
  try {
    mesh = read_mesh(world.from / b.file);
  } catch (const Error& e) {
    b.object.error("geometryFile",
                   fmt::format("is {}: {}", toml_string(b.file), e.diagnostics().front().message));
    return "";
  }
  const MeshSolid solid = solid_of_mesh(mesh, b.place.scale);
  if (becomes_tank(b, solid, world)) {
    b.object.missing("density", "it stands");
    b.object.missing("friction", "walls have 1");
    b.object.missing("restitution", "walls have 1");
    b.object.finish();
    return "";
  }
  for (const BodyPoint& p : mesh.points) world.extent.add(b.place(p));
  std::string tables;
  std::vector<TomlTable> shapes = shapes_of(b, mesh, solid, world);
  for (std::size_t part = 0; part < shapes.size(); ++part) {
    TomlTable& table = shapes[part];
    if (b.inside) table.set("side", "inside");
    set_slip(sticks, table);
    if (!b.stands())
      table.set("name", shapes.size() == 1 ? b.name : fmt::format("{}_{}", b.name, part));
    const std::string keys = set_motion(b, world.duration, world, table);
    tables += table.item(b.dynamic || b.motor || b.animated ? "body" : "wall") + keys;
  }
  b.object.missing("density", "only of use for a dynamic body");
  b.object.missing("velocity", "only of use for a dynamic body");
  b.object.missing("friction", "only of use for a dynamic body");
  b.object.missing("restitution", "only of use for a dynamic body");
  b.object.finish();
  return tables;
}

SplishBody* body_of_joint(std::vector<SplishBody>& bodies, JsonObject& joint, const char* key) {
  const long id = joint.integer(key, -1, -1000000000, 1000000000);
  for (SplishBody& b : bodies)
    if (b.id == id) return &b;
  joint.error(key, fmt::format("is {}, and no body has this id; set RigidBodies[k].id", id));
  return nullptr;
}

/// A motor on a standing body moves the other one; motors between moving bodies are joints. The
/// target is the angular velocity of the second body minus that of the first.
void read_motors(std::vector<JsonObject>& motors, std::vector<SplishBody>& bodies) {
  for (JsonObject& m : motors) {
    SplishBody* first = body_of_joint(bodies, m, "bodyID1");
    SplishBody* second = body_of_joint(bodies, m, "bodyID2");
    if (!first || !second) continue;
    if (first->dynamic != second->dynamic) {
      SplishBody* turned = first->dynamic ? first : second;
      turned->motor = &m;
      turned->motor_sign = first->dynamic ? -1 : 1;
    } else if (!first->dynamic) m.missing("bodyID1", "a motor between two standing bodies");
    else m.missing("bodyID1", "a motor between two moving bodies is left out; add a [joint]");
  }
}

}  // namespace

std::string read_splish_bodies(JsonObject& scene, bool sticks, SplishWorld& world) {
  std::vector<SplishBody> bodies;
  for (JsonObject& object : scene.list("RigidBodies"))
    bodies.push_back(read_body(object, bodies.size(), world));
  std::vector<JsonObject> motors = scene.list("TargetVelocityMotorHingeJoints");
  read_motors(motors, bodies);
  std::string tables;
  for (SplishBody& b : bodies) tables += write_body(b, sticks, world);
  for (JsonObject& m : motors) m.finish();
  for (const char* joints :
       {"BallJoints", "BallOnLineJoints", "HingeJoints", "UniversalJoints", "SliderJoints",
        "RigidBodyParticleBallJoints", "RigidBodySprings", "DistanceJoints",
        "TargetAngleMotorHingeJoints", "TargetPositionMotorSliderJoints",
        "TargetVelocityMotorSliderJoints", "DamperJoints", "TriangleModels", "TetModels"})
    scene.missing(joints,
                  "joints and soft bodies of PositionBasedDynamics are left out; docs/bodies.md "
                  "describes [joint]");
  scene.missing("Simulation",
                "settings of PositionBasedDynamics; Bullet moves free bodies instead");
  return tables;
}

}  // namespace freshet
