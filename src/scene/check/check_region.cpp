// SPDX-License-Identifier: MIT
/// The shapes of regions: the keys that each requires, and the keys that it does not read.
#include <fmt/ranges.h>

#include <algorithm>

#include "scene/check/findings.h"
#include "scene/keys/keys.h"
#include "scene/model/loaded_mesh.h"

namespace freshet {
namespace {

constexpr const char* all_keys[] = {
    "min",   "max",    "from", "count", "center",   "radius",      "length", "axis",
    "point", "normal", "file", "scale", "rotation", "translation", "points", "base"};

/// The keys that each shape requires.
std::vector<std::string> needed_keys(Shape shape) {
  switch (shape) {
    case Shape::box:
      return {"min", "max"};
    case Shape::lattice:
      return {"from", "count"};
    case Shape::sphere:
      return {"center", "radius"};
    case Shape::cylinder:
      return {"center", "radius", "length"};
    case Shape::plane:
      return {"point", "normal"};
    case Shape::points:
    case Shape::mesh:
      return {"file"};
    case Shape::polygon:
      return {};
  }
  return {};
}

/// The optional keys of a shape.
std::vector<std::string> further_keys(Shape shape) {
  if (shape == Shape::cylinder) return {"axis"};
  if (shape == Shape::mesh || shape == Shape::points) return {"scale", "rotation", "translation"};
  if (shape == Shape::polygon)
    return {"points", "file", "base", "scale", "rotation", "translation"};
  if (shape == Shape::box) return {"rotation"};
  return {};
}

bool has(const Scene::Region& r, const std::string& key) {
  const std::pair<const char*, bool> filled[] = {
      {"min", !r.min.empty()},       {"max", !r.max.empty()},       {"from", !r.from.empty()},
      {"count", !r.count.empty()},   {"center", !r.center.empty()}, {"radius", r.radius > 0},
      {"length", r.length > 0},      {"axis", !r.axis.empty()},     {"point", !r.point.empty()},
      {"normal", !r.normal.empty()}, {"file", !r.file.empty()}};
  return std::any_of(std::begin(filled), std::end(filled),
                     [&](const auto& f) { return f.first == key && f.second; });
}

void check_unused(const RegionAt& at, Findings& out) {
  const Shape shape = at.region.shape;
  auto read = needed_keys(shape);
  for (const std::string& key : further_keys(shape)) read.push_back(key);
  const auto unused = [&](const char* key) {
    out.unused(at.path + key, fmt::format("{}.{}", at.name, key),
               fmt::format("{}.shape is \"{}\"; remove it or change the shape", at.name,
                           shape_words[int(shape)]));
  };
  for (const char* key : all_keys)
    if (std::find(read.begin(), read.end(), key) == read.end()) unused(key);
  if (shape == Shape::lattice || shape == Shape::points) unused("side");
}

bool check_needed(const RegionAt& at, Findings& out) {
  std::vector<std::string> keys;
  bool whole = true;
  for (const std::string& key : needed_keys(at.region.shape)) {
    keys.push_back(fmt::format("{}.{}", at.name, key));
    whole &= has(at.region, key);
  }
  if (whole) return true;
  std::string list = keys[0];
  for (std::size_t k = 1; k < keys.size(); ++k)
    list += (k + 1 == keys.size() ? " and " : ", ") + keys[k];
  out.error(at.path, fmt::format("{}.shape is \"{}\" and needs {}", at.name,
                                 shape_words[int(at.region.shape)], list));
  return false;
}

bool check_box(const RegionAt& at, Findings& out) {
  for (std::size_t k = 0; k < at.region.min.size(); ++k)
    if (!(at.region.max[k] > at.region.min[k])) {
      out.error(at.path + "max",
                fmt::format("{0}.max is not above {0}.min in {1}; swap them or make the {0} larger",
                            at.name, axis_names[k]));
      return false;
    }
  return true;
}

bool check_direction(const RegionAt& at, const char* key, const Vector& v, Findings& out) {
  if (std::any_of(v.begin(), v.end(), [](double x) { return x != 0; })) return true;
  out.error(at.path + key, fmt::format("{}.{} is 0 and has no direction; set one, for example {}",
                                       at.name, key, v.size() == 3 ? "[0, 1, 0]" : "[0, 1]"));
  return false;
}

/// The corners of a polygon.
bool check_polygon(const Scene& s, const RegionAt& at, Findings& out) {
  const Scene::Region& r = at.region;
  if (r.points.empty() == r.file.empty()) {
    out.error(r.points.empty() ? at.path : at.path + "file",
              fmt::format("{0}.shape is \"polygon\", and {1} of {0}.points and {0}.file {2} set; "
                          "set one of them",
                          at.name, r.points.empty() ? "neither" : "both",
                          r.points.empty() ? "is" : "are"));
    return false;
  }
  std::shared_ptr<const LoadedMesh> loaded = r.loaded;
  try {
    if (!loaded) loaded = load_mesh(r, 0);
  } catch (const Error& e) {
    for (const Diagnostic& d : e.diagnostics())
      if (d.place != r.file) out.list.push_back(d);
      else if (r.file.empty())
        out.error(at.path + "points", fmt::format("{}.points {}", at.name, d.message));
      else
        out.error(at.path + "file",
                  fmt::format("{}.file is \"{}\": {}", at.name, r.file, d.message));
    return false;
  }
  auto low = loaded->distance.low(), high = loaded->distance.high();
  for (int k = 0; k < 2; ++k)
    if (const auto j = std::size_t(k);
        component(high, k) <= s.domain.min[j] || component(low, k) >= s.domain.max[j]) {
      out.error(at.path + (r.file.empty() ? "points" : "file"),
                fmt::format("the polygon, from [{:.4g}, {:.4g}] to [{:.4g}, {:.4g}], misses the "
                            "domain; move it with {}.translation",
                            low.x, low.y, high.x, high.y, at.name));
      return false;
    }
  return true;
}

}  // namespace

bool check_region(const Scene& s, const RegionAt& at, Findings& out) {
  const Scene::Region& r = at.region;
  if (s.dimension() == 2 && (r.shape == Shape::cylinder || r.shape == Shape::mesh)) {
    const bool mesh = r.shape == Shape::mesh;
    out.error(at.path + "shape",
              fmt::format("{}.shape is \"{}\", and the scene is in 2D{}", at.name,
                          shape_words[int(r.shape)],
                          mesh ? "; choose another shape, or add a third number to domain.max"
                               : ", where a disc is shape = \"sphere\"; choose that"));
    return false;
  }
  if (s.dimension() == 3 && r.shape == Shape::polygon) {
    out.error(at.path + "shape",
              fmt::format("{}.shape is \"polygon\", and the scene is in 3D; choose another shape, "
                          "such as a mesh",
                          at.name));
    return false;
  }
  check_unused(at, out);
  if (!check_needed(at, out)) return false;
  if (r.shape == Shape::box) return check_box(at, out);
  if (r.shape == Shape::polygon) return check_polygon(s, at, out);
  if (r.shape == Shape::cylinder) return check_direction(at, "axis", r.axis, out);
  if (r.shape == Shape::plane) return check_direction(at, "normal", r.normal, out);
  return r.shape != Shape::mesh || check_mesh(s, at, out);
}

std::optional<PointCloud> check_points(const Scene& s, const RegionAt& at, Findings& out) {
  try {
    return region_points(at.region, s.dimension());
  } catch (const Error& e) {
    for (const Diagnostic& d : e.diagnostics())
      if (d.place == at.region.file)  // an error of the whole file is reported at the key
        out.error(at.path + "file",
                  fmt::format("{}.file is \"{}\": {}", at.name, at.region.file, d.message));
      else out.list.push_back(d);
    return {};
  }
}

}  // namespace freshet
