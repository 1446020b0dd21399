// SPDX-License-Identifier: MIT
#include "run/film_scene.h"

#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "io/surface_files.h"
#include "render/bodies.h"
#include "render/camera.h"
#include "render/color.h"
#include "scene/model/body_mesh.h"
#include "scene/model/body_shape.h"
#include "scene/model/solid_of.h"

namespace freshet {
namespace {

using Json = nlohmann::ordered_json;

constexpr Color wall_color{176, 172, 166};

std::string hex(Color c) { return fmt::format("#{:02x}{:02x}{:02x}", c.r, c.g, c.b); }

Json json_of(Point p) { return Json{p.x, p.y, p.z}; }

/// A body or a wall as a picture shows it.
struct Part {
  std::string name, file;
  TriangleMesh mesh;
  Color color;
  bool around;  // the liquid is inside
};

/// The bodies, about their centres of mass.
std::vector<Part> body_parts(const Scene& scene) {
  std::vector<Part> all;
  for (std::size_t k = 0; k < scene.body.size(); ++k) {
    const Scene::Body& body = scene.body[k];
    TriangleMesh mesh = body_mesh(body);
    const Point center = body_shape(body).center;
    for (Point& p : mesh.points) p = p - center;
    all.push_back({body.name.empty() ? fmt::format("body[{}]", k) : body.name,
                   fmt::format("body{}.glb", k), std::move(mesh), body_color(scene, k),
                   body.side == Side::inside});
  }
  return all;
}

/// The walls that have a finite surface.
std::vector<Part> wall_parts(const Scene& scene) {
  std::vector<Part> all;
  for (std::size_t k = 0; k < scene.wall.size(); ++k) {
    const Scene::Wall& wall = scene.wall[k];
    if (!(is_mesh(wall) ? bool(wall.loaded) : is_solid(wall) && wall.shape != Shape::plane))
      continue;
    Scene::Body shape;
    static_cast<Scene::Region&>(shape) = wall;
    all.push_back({wall.name.empty() ? fmt::format("wall[{}]", k) : wall.name,
                   fmt::format("wall{}.glb", k), body_mesh(shape), wall_color,
                   wall.side == Side::inside});
  }
  return all;
}

Json json_of(const std::vector<Part>& parts) {
  Json all = Json::array();
  for (const Part& part : parts)
    all.push_back({{"name", part.name},
                   {"mesh", part.file},
                   {"color", hex(part.color)},
                   {"around", part.around}});
  return all;
}

/// A mesh with normals, which are weighted by the areas of the triangles around a point.
SurfaceMesh with_normals(const TriangleMesh& mesh) {
  std::vector<Point> normals(mesh.points.size());
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    const auto [a, b, c] = mesh.corners(int(t));
    for (const int corner : mesh.triangles[t]) normals[std::size_t(corner)] += cross(b - a, c - a);
  }
  const auto floats = [](Point p) {
    return SurfaceMesh::Point{float(p.x), float(p.y), float(p.z)};
  };
  SurfaceMesh all;
  for (std::size_t k = 0; k < mesh.points.size(); ++k) {
    const double length = norm(normals[k]);
    all.position.push_back(floats(mesh.points[k]));
    all.normal.push_back(floats(length > 0 ? normals[k] / length : Point{0, 1, 0}));
  }
  for (const auto& [a, b, c] : mesh.triangles)
    all.triangles.push_back({std::uint32_t(a), std::uint32_t(b), std::uint32_t(c)});
  return all;
}

/// The liquids. One alone without a colour has none: it is shown as water.
Json json_of_liquids(const Scene& scene) {
  Json all = Json::array();
  const auto liquids = scene.liquids();
  const std::vector<Color> colors = liquid_colors(scene);
  for (std::size_t k = 0; k < liquids.size(); ++k) {
    const bool water = liquids.size() == 1 && liquids[k].color.empty();
    all.push_back({{"color", water ? Json() : Json(hex(colors[k]))},
                   {"rest_density", liquids[k].rest_density},
                   {"viscosity", liquids[k].viscosity}});
  }
  return all;
}

/// Which sides of the domain are walls: x_min, x_max, y_min, y_max, z_min, z_max.
Json json_of_sides(const Scene& scene) {
  Json all = Json::array();
  for (int side = 0; side < 6; ++side)
    all.push_back(!scene.periodic(side / 2) && !scene.is_open(side));
  return all;
}

}  // namespace

std::string film_frame_file(std::int64_t number) { return fmt::format("frame_{:04}.json", number); }

std::string film_surface_file(std::size_t liquid, std::int64_t number) {
  return fmt::format("liquid{}_{:04}.glb", liquid, number);
}

std::string encode_film_scene(const Scene& scene, const FilmPicture& picture) {
  const Json json{{"format", 1},
                  {"width", picture.width},
                  {"height", picture.height},
                  {"samples", picture.samples},
                  {"spacing", scene.particles.spacing},
                  {"domain", {{"min", scene.domain.min}, {"max", scene.domain.max}}},
                  {"walls_of_domain", json_of_sides(scene)},
                  {"liquids", json_of_liquids(scene)},
                  {"walls", json_of(wall_parts(scene))},
                  {"bodies", json_of(body_parts(scene))}};
  return json.dump(2) + "\n";
}

std::map<std::string, std::string> encode_film_solids(const Scene& scene) {
  std::map<std::string, std::string> all;
  for (const auto& parts : {body_parts(scene), wall_parts(scene)})
    for (const Part& part : parts)
      all[part.file] = encode_solid_glb(
          with_normals(part.mesh),
          {part.name,
           {float(part.color.r) / 255, float(part.color.g) / 255, float(part.color.b) / 255},
           0.7f});
  return all;
}

std::string encode_film_frame(const Scene& scene, const Frame& frame, std::int64_t number) {
  const Pose pose = pose_at(scene, frame.time);
  Json surfaces = Json::array(), bodies = Json::array();
  for (std::size_t k = 0; k < scene.liquids().size(); ++k)
    surfaces.push_back(film_surface_file(k, number));
  for (const BodyState& body : frame.bodies)
    bodies.push_back({{"position", body.position}, {"orientation", body.orientation}});
  const Json json{{"time", frame.time},
                  {"step", frame.step},
                  {"surfaces", surfaces},
                  {"bodies", bodies},
                  {"camera",
                   {{"position", json_of(pose.eye)},
                    {"target", json_of(pose.target)},
                    {"field_of_view", pose.field_of_view}}}};
  return json.dump(2) + "\n";
}

}  // namespace freshet
