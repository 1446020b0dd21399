// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <cmath>

#include "import/dualsphysics.h"
#include "import/mesh_solid.h"

namespace freshet {
namespace {

using WallPoint = Vec<3, double>;

double& axis_in(WallPoint& p, int k) { return k == 0 ? p.x : k == 1 ? p.y : p.z; }

/// A box whose sides are where its boundary particles stand.
Bounds snapped(const DsphShape& s, const DsphWorld& world) {
  Bounds box{s.frame(s.low), s.frame(s.high)};
  for (int k = 0; k < world.dimension; ++k)
    for (WallPoint* p : {&box.low, &box.high})
      axis_in(*p, k) = world.lattice->coordinate(k, world.lattice->nearest(k, axis_in(*p, k)));
  return box;
}

unsigned sides_in(const DsphShape& s, const DsphWorld& world) {
  return s.solid ? all_dsph_sides : s.sides & (world.flat() ? 15u : all_dsph_sides);
}

/// Whether no fluid is beyond the sides of a box.
bool holds_all_fluid(const DsphShape& s, const DsphWorld& world) {
  Bounds box = snapped(s, world), water = world.lattice->extent(true);
  for (int k = 0; k < world.dimension; ++k) {
    const unsigned sides = sides_in(s, world) >> (2 * k);
    if ((sides & 1u && axis_in(water.low, k) < axis_in(box.low, k) + world.dp / 2) ||
        (sides & 2u && axis_in(water.high, k) > axis_in(box.high, k) - world.dp / 2))
      return false;
  }
  return true;
}

/// The box that holds the fluid: its inside becomes the domain, or it is a body.
const DsphShape* tank_of(const DsphWorld& world) {
  const DsphShape* tank = nullptr;
  double largest = 0;
  for (const DsphShape& s : world.shapes) {
    if (s.kind != DsphShape::Kind::box || s.solid || s.frame.turned() || !world.holds_fluid(s) ||
        !holds_all_fluid(s, world) || world.floating.contains(s.mk()))
      continue;
    const WallPoint size = s.high - s.low;
    if (const double volume = size.x * size.y * size.z; volume > largest) {
      largest = volume;
      tank = &s;
    }
  }
  return tank;
}

TomlTable box_table(const Bounds& box, const DsphWorld& world) {
  TomlTable table;
  table.set("shape", "box");
  table.set("min", box.low, world.dimension);
  table.set("max", box.high, world.dimension);
  return table;
}

/// A box that is turned by its frame.
TomlTable turned_box(const WallPoint& low, const WallPoint& high, const DsphFrame& frame,
                     const DsphWorld& world) {
  const WallPoint half = 0.5 * frame.scale * (high - low), center = frame(0.5 * (low + high));
  TomlTable table = box_table({center - half, center + half}, world);
  if (!frame.turned()) return table;
  const WallPoint degrees = frame.degrees();
  if (world.flat()) table.set("rotation", degrees.z);
  else table.set("rotation", degrees, 3);
  return table;
}

/// The sides of a box as plates behind their surfaces, which are half a spacing before the places.
std::vector<TomlTable> plates_of(const DsphShape& s, const DsphWorld& world) {
  const double half = world.dp / 2;
  Bounds box = s.frame.turned() ? Bounds{s.low, s.high} : snapped(s, world);
  const DsphFrame frame = s.frame.turned() ? s.frame : DsphFrame{};
  const double out = world.holds_fluid(s) ? 1 : -1;
  const WallPoint d{half, half, half};
  std::vector<TomlTable> plates;
  for (int k = 0; k < world.dimension; ++k)
    for (const bool high : {false, true}) {
      if (!(sides_in(s, world) >> (2 * k + (high ? 1 : 0)) & 1u)) continue;
      WallPoint low_corner = box.low - d, high_corner = box.high + d;
      const double face = axis_in(high ? box.high : box.low, k), way = high ? out : -out;
      const double surface = face - way * half, behind = surface + way * world.support;
      axis_in(low_corner, k) = std::min(surface, behind);
      axis_in(high_corner, k) = std::max(surface, behind);
      plates.push_back(turned_box(low_corner, high_corner, frame, world));
    }
  return plates;
}

/// A wall reaches half a spacing beyond its places. Free bodies, which may touch, do not.
double grown_by(const DsphShape& s, const DsphWorld& world) {
  return world.floating.contains(s.mk()) ? 0 : world.dp / 2;
}

std::vector<TomlTable> tables_of_box(const DsphShape& s, const DsphWorld& world) {
  const int sides = std::popcount(sides_in(s, world));
  const bool closed = s.solid || (sides >= world.dimension + 1 && !world.holds_fluid(s));
  if (!closed) return plates_of(s, world);
  const double half = grown_by(s, world) / s.frame.scale;
  const WallPoint d{half, half, half};
  if (s.frame.turned()) return {turned_box(s.low - d, s.high + d, s.frame, world)};
  const Bounds box = snapped(s, world);
  return {box_table({box.low - d, box.high + d}, world)};
}

std::vector<TomlTable> tables_of_round(const DsphShape& s, const DsphWorld& world) {
  TomlTable table;
  const bool holds = world.holds_fluid(s);
  const double half = grown_by(s, world), radius = s.radius + (holds ? -half : half);
  const WallPoint axis = s.high - s.low;
  if (s.kind == DsphShape::Kind::sphere || world.flat()) {
    table.set("shape", "sphere");
    table.set("center", s.low, world.dimension);
    table.set("radius", radius);
  } else {
    table.set("shape", "cylinder");
    table.set("center", 0.5 * (s.low + s.high), 3);
    table.set("radius", radius);
    table.set("length", norm(axis) + (holds ? -2 : 2) * half);
    table.set("axis", axis, 3);
  }
  if (holds) table.set("side", "inside");
  return {table};
}

std::vector<TomlTable> tables_of_mesh(const DsphShape& s, const DsphWorld& world) {
  TomlTable table;
  if (!world.flat()) {
    DsphFrame upright;  // turns z upwards into y
    upright.y = from_dsph({0, 1, 0});
    upright.z = from_dsph({0, 0, 1});
    const DsphFrame frame = s.frame.of(upright);
    table.set("shape", "mesh");
    table.set("file", path_for_toml(s.file, world.from, world.to));
    if (frame.scale != 1) table.set("scale", frame.scale);
    table.set("rotation", frame.degrees(), 3);
    if (norm(frame.shift) > 0) table.set("translation", frame.shift, 3);
    return {table};
  }
  TriangleMesh mesh = read_mesh(world.from / s.file);
  for (WallPoint& p : mesh.points) {
    p = s.frame(from_dsph(p));
    p.z -= world.plane_z;
  }
  std::vector<TomlTable> parts;
  for (const auto& loop : section_of_mesh(mesh, {}, world.dp / 2)) {
    parts.emplace_back();
    parts.back().set("shape", "polygon");
    parts.back().line("points", polygon_of(loop));
  }
  return parts;
}

std::vector<TomlTable> tables_of(const DsphShape& s, const DsphWorld& world) {
  switch (s.kind) {
    case DsphShape::Kind::box:
      return tables_of_box(s, world);
    case DsphShape::Kind::profile:
      return tables_of_profile(s, world);
    case DsphShape::Kind::mesh:
      return tables_of_mesh(s, world);
    default:
      return tables_of_round(s, world);
  }
}

/// The domain: inside the tank as far as it has sides, else the room of the simulation.
void write_domain(const DsphShape* tank, Bounds room, const DsphWorld& world, DsphWalls& result) {
  const double half = world.dp / 2;
  const Bounds places = world.lattice->extent(false);
  if (!tank) {
    const WallPoint around = (2 * world.support) * WallPoint{1, 1, 1};
    room.low = room.low - around;
    room.high = room.high + around;
  }
  // The sides are opened one by one: bodies consist of the layers of walls.method.
  for (int k = 0; k < world.dimension; ++k) {
    WallPoint first = places.low, last = places.high;
    double &low = axis_in(room.low, k), &high = axis_in(room.high, k);
    if (world.periodic >> k & 1u) {
      low = axis_in(first, k) - half;
      high = axis_in(last, k) + half;
      continue;
    }
    for (const bool upper : {false, true}) {
      Bounds box = tank ? snapped(*tank, world) : room;
      const double face = axis_in(upper ? box.high : box.low, k);
      const bool drawn = tank && (sides_in(*tank, world) >> (2 * k + (upper ? 1 : 0)) & 1u) &&
                         world.lattice->contains(k, world.lattice->nearest(k, face));
      if (drawn) (upper ? high : low) = upper ? face - half : face + half;
      else result.walls.set(fmt::format("{}_{}", "xyz"[k], upper ? "max" : "min"), "open");
    }
  }
  result.domain.set("min", room.low, world.dimension);
  result.domain.set("max", room.high, world.dimension);
}

}  // namespace

DsphWalls write_dsph_walls(const Bounds& room, DsphWorld& world) {
  DsphWalls result;
  const DsphShape* tank = tank_of(world);
  const bool moves = tank && world.moved.contains(tank->mk());
  Bounds around = room;
  if (moves) {  // it may turn
    const WallPoint size = room.size();
    const double reach = 0.5 * std::max({size.x, size.y, world.flat() ? 0 : size.z});
    around.low = room.low - WallPoint{reach, reach, reach};
    around.high = room.high + WallPoint{reach, reach, reach};
  }
  write_domain(moves ? nullptr : tank, around, world, result);
  std::map<long, int> parts;
  for (const DsphShape& s : world.shapes) {
    if (&s == tank && !moves) continue;
    std::vector<TomlTable> tables;
    if (&s == tank) {
      const Bounds box = snapped(s, world);
      const double half = world.dp / 2;
      const WallPoint d{half, half, half};
      tables = {box_table({box.low + d, box.high - d}, world)};
      tables.back().set("side", "inside");
    } else tables = tables_of(s, world);
    const bool free = world.floating.contains(s.mk()), moved = world.moved.contains(s.mk());
    for (TomlTable& table : tables) {
      if (!free && !moved) {
        result.tables += table.item("wall");
        continue;
      }
      const int part = parts[s.mk()]++;
      table.set("name",
                part == 0 ? fmt::format("mk_{}", s.mk()) : fmt::format("mk_{}_{}", s.mk(), part));
      const std::string keys = write_dsph_motion(s.mk(), world, table);
      result.tables += table.item("body") + keys;
    }
  }
  for (const auto& [mk, part] : parts)
    if (part > 1 && world.floating.contains(mk))
      world.floating.at(mk).instead(fmt::format(
          "has {} parts, which move together; taken instead: bodies of their own", part));
  return result;
}

}  // namespace freshet
