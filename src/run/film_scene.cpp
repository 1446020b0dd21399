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
                   {"color", hex_code(part.color)},
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

Json json_of_liquids(const Scene& scene, const std::vector<LiquidMaterial>& materials) {
  Json all = Json::array();
  const auto liquids = scene.liquids();
  for (std::size_t k = 0; k < liquids.size(); ++k)
    all.push_back({{"color", materials[k].color},
                   {"ior", materials[k].ior},
                   {"absorption", materials[k].absorption},
                   {"scattering", materials[k].scattering},
                   {"roughness", materials[k].roughness},
                   {"rest_density", liquids[k].rest_density},
                   {"viscosity", liquids[k].viscosity}});
  return all;
}

/// Which sides of the domain are walls that the liquid touches: x_min, x_max, y_min, ...
Json json_of_sides(const Scene& scene, const FilmView& view) {
  Json all = Json::array();
  for (int side = 0; side < 6; ++side)
    all.push_back(!scene.periodic(side / 2) && !scene.is_open(side) &&
                  view.touched[std::size_t(side)]);
  return all;
}

Json json_of_bodies(const Scene& scene, const std::vector<BodyMaterial>& materials) {
  Json all = json_of(body_parts(scene));
  for (std::size_t k = 0; k < materials.size(); ++k) {
    const BodyMaterial& m = materials[k];
    all[k]["color"] = m.color;
    all[k]["material"] = {{"kind", m.kind}, {"roughness", m.roughness}, {"ior", m.ior}};
  }
  return all;
}

}  // namespace

std::string film_frame_file(std::int64_t number) { return fmt::format("frame_{:04}.json", number); }

std::string film_surface_file(std::size_t liquid, std::int64_t number) {
  return fmt::format("liquid{}_{:04}.glb", liquid, number);
}
std::string film_whitewater_file(std::int64_t number) {
  return fmt::format("whitewater_{:04}.ply", number);
}

std::string encode_film_scene(const Scene& scene, const FilmLook& look) {
  const FilmView& view = look.view;
  const Json json{{"format", 2},
                  {"title", scene.title},
                  {"width", look.picture.width},
                  {"height", look.picture.height},
                  {"samples", look.picture.samples},
                  {"shutter", look.picture.shutter},
                  {"denoise", look.picture.denoise},
                  {"spacing", scene.particles.spacing},
                  {"domain", {{"min", scene.domain.min}, {"max", scene.domain.max}}},
                  {"seen", {{"min", json_of(view.seen.low)}, {"max", json_of(view.seen.high)}}},
                  {"walls_of_domain", json_of_sides(scene, view)},
                  {"tank_top", view.tank_top},
                  {"liquids", json_of_liquids(scene, look.materials.liquids)},
                  {"walls", json_of(wall_parts(scene))},
                  {"bodies", json_of_bodies(scene, look.materials.bodies)}};
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

std::string encode_film_frame(const Scene& scene, const Frame& frame, std::int64_t number,
                              const FilmView& view) {
  const Pose pose = pose_at(scene, frame.time, view.seen);
  Json surfaces = Json::array(), whitewater = Json::array(), bodies = Json::array();
  for (std::size_t k = 0; k < scene.liquids().size(); ++k)
    surfaces.push_back(film_surface_file(k, number));
  if (frame.whitewater.size() > 0) whitewater.push_back(film_whitewater_file(number));
  for (const BodyState& body : frame.bodies)
    bodies.push_back({{"position", body.position},
                      {"orientation", body.orientation},
                      {"velocity", body.velocity},
                      {"angular_velocity", body.angular_velocity}});
  const Json json{{"time", frame.time},
                  {"step", frame.step},
                  {"surfaces", surfaces},
                  {"whitewater", whitewater},
                  {"bodies", bodies},
                  {"camera",
                   {{"position", json_of(pose.eye)},
                    {"target", json_of(pose.target)},
                    {"field_of_view", pose.field_of_view}}}};
  return json.dump(2) + "\n";
}

}  // namespace freshet
