// SPDX-License-Identifier: MIT
#include "scene/check/body_warnings.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "freshet/units.h"
#include "scene/check/findings.h"
#include "scene/keys/keys.h"
#include "scene/model/body_motion.h"
#include "scene/model/body_shape.h"
#include "scene/model/loaded_mesh.h"
#include "scene/model/setup.h"
#include "scene/sample/sample_walls.h"

namespace freshet {
namespace {

constexpr double lightest = 0.1;  // of the fluid's density: lighter bodies are untested
/// Spacings: the buoyancy of balls from this radius on is known (docs/bodies.md).
constexpr double smallest_ball = 1.5;

struct Length {
  const char* key;
  double value;
};
/// The thickness of a wall or body, and the key that sets it. For a polygon or a closed mesh, the
/// thickness of its box; an open mesh is a sheet.
Length thickness(const Scene::Region& r, double spacing) {
  if (r.shape == Shape::mesh && !r.loaded->condition.closed()) return {"file", spacing};
  if (r.side == Side::inside) return {"", INFINITY};
  if (r.shape == Shape::sphere) return {"radius", 2 * r.radius};
  if (r.shape == Shape::cylinder && r.length < 2 * r.radius) return {"length", r.length};
  if (r.shape == Shape::cylinder) return {"radius", 2 * r.radius};
  if (r.shape == Shape::polygon || r.shape == Shape::mesh) {
    const auto sides = sides_of(*r.loaded);
    const double least = std::min(sides.x, sides.y);
    return {"scale", r.shape == Shape::polygon ? least : std::min(least, sides.z)};
  }
  double least = INFINITY;
  for (std::size_t d = 0; d < r.min.size(); ++d) least = std::min(least, r.max[d] - r.min[d]);
  return {"max", least};
}

/// A warning if fluid particles on both sides of a wall or body are closer than the support radius.
void warn_of_thin(const Scene& s, const Derived& d, const Scene::Region& r, std::string key,
                  const std::string& name, std::vector<Diagnostic>& list) {
  const Length thick = thickness(r, d.spacing);
  const double needed = d.support_radius - d.spacing;
  if (!(thick.value < needed * (1 - 1e-6))) return;
  list.push_back({Diagnostic::Severity::warning, place_of(s, key + thick.key),
                  fmt::format("{} is {:.4g} m thick. Where both sides are wet, fluid particles on "
                              "its two sides interact across it unless it is {:.4g} m thick; make "
                              "it thicker, or the spacing or the support radius smaller",
                              name, thick.value, needed)});
}

/// Centres of mass and moments of inertia that need mass outside the shape.
template <class Warn>
void warn_of_mass(const Scene::Body& b, const std::string& at, const std::string& name, Warn warn) {
  if (b.inertia.empty()) return;
  const BodyShape shape = body_shape(b);
  const double off = norm(shape.center - shape.middle);
  if (off > shape.extent / 2)
    warn(at + "center_of_mass",
         fmt::format("the centre of mass of {} is {:.4g} m from the middle of its shape, which "
                     "reaches {:.4g} m: is it in metres, and at the place of the body?",
                     name, off, shape.extent / 2));
  const Units units = units_in(b.inertia.size() == 1 ? 2 : 3);
  const auto& i = shape.inertia;
  const double second = b.inertia.size() == 1 ? i[2][2] : (i[0][0] + i[1][1] + i[2][2]) / 2;
  const double gyration = std::sqrt(second / shape.volume);
  if (gyration > shape.reach)
    warn(
        at + "inertia",
        fmt::format("the inertia of {} is that of its mass {:.4g} m from its centre, and its shape "
                    "reaches {:.4g} m: is it in {}?",
                    name, gyration, shape.reach, raised_unit(units.inertia)));
}

}  // namespace

std::vector<Diagnostic> thin_wall_warnings(const Scene& s, const Derived& d) {
  std::vector<Diagnostic> list;
  if (!has_fluid(s)) return list;
  const std::vector<std::string> names = s.wall_names();
  const std::size_t sides = names.size() - s.wall.size();
  for (std::size_t k = 0; k < s.wall.size(); ++k)
    if (wall_layers(s, s.wall_method(k)) > 0 && s.wall[k].shape != Shape::points)
      warn_of_thin(s, d, s.wall[k], fmt::format("wall[{}].", k), names[sides + k], list);
  if (body_method(s) != WallMethod::adami2012)
    for (std::size_t k = 0; k < s.body.size(); ++k)
      warn_of_thin(s, d, s.body[k], fmt::format("body[{}].", k), s.body_name(k), list);
  return list;
}

std::vector<Diagnostic> body_warnings(const Scene& s, const Derived& d) {
  std::vector<Diagnostic> list;
  const auto warn = [&](const std::string& key, std::string message) {
    list.push_back({Diagnostic::Severity::warning, place_of(s, key), std::move(message)});
  };
  const bool layered = body_method(s) == WallMethod::adami2012;
  const bool obstacle = std::any_of(s.body.begin(), s.body.end(),
                                    [](const auto& b) { return b.side == Side::outside; });
  if (s.solver.name == SolverName::delta_sph && !layered && obstacle && has_fluid(s))
    warn(
        "walls.method",
        fmt::format("with walls.method = \"{}\", a body has one layer of \"akinci2012\" particles, "
                    "which delta_sph lifts too strongly: balls of 1.5 to 3 spacings by 26 to 37 %; "
                    "set walls.method = \"adami2012\"",
                    method_words[int(*s.walls.method)]));
  bool free = false;
  for (std::size_t k = 0; k < s.body.size(); ++k) {
    const Scene::Body& b = s.body[k];
    const std::string at = fmt::format("body[{}].", k), name = s.body_name(k);
    free |= b.motion == BodyMotion::free;
    const double reached = wall_layers(s, WallMethod::adami2012) * d.spacing;
    const Length thick = thickness(b, d.spacing);
    if (layered && has_fluid(s) && thick.value < reached * (1 - 1e-6))
      warn(at + thick.key,
           fmt::format(
               "{} is {:.4g} m thick, and \"adami2012\" needs {:.4g} m for layers of body "
               "particles that fill the support radius: the fluid in front of it interacts with "
               "what is behind it; make it thicker or the spacing smaller",
               name, thick.value, reached));
    if (b.shape == Shape::sphere && b.side == Side::outside && has_fluid(s) &&
        b.radius < smallest_ball * d.spacing * (1 - 1e-6))
      warn(at + "radius",
           fmt::format("{} has a radius of {:.2g} spacings: its buoyancy may be more than 5 % off; "
                       "{:g} spacings or more are better; make it larger or the spacing smaller",
                       name, b.radius / d.spacing, smallest_ball));
    if (b.motion == BodyMotion::free) {
      const double density = body_shape(b).density();
      if (has_fluid(s) && density < lightest * d.rest_density)
        warn(at + (b.density ? "density" : "mass"),
             b.side == Side::inside
                 ? fmt::format("{} has {:.2g} times the mass of the fluid that fits into it: its "
                               "motion may oscillate; {:g} times or more are stable",
                               name, density / d.rest_density, lightest)
                 : fmt::format("{} has {:.2g} times the density of the fluid: the fluid that it "
                               "displaces is so much heavier that its motion may oscillate; {:g} "
                               "times or more are stable",
                               name, density / d.rest_density, lightest));
      warn_of_mass(b, at, name, warn);
    }
    if (b.motion != BodyMotion::moved || s.time.adaptive || !has_fluid(s)) continue;
    const double bound = 0.4 * d.support_radius / 2 / fastest_point(b, s.dimension(), s.time.end);
    if (s.time.step > bound)
      warn("time.step", fmt::format("the time step {:.4g} s is longer than {:.4g} s, in which {} "
                                    "moves 0.4 h; fluid may pass through it; make it shorter",
                                    s.time.step, bound, name));
  }
  for (std::size_t k = 0; k < s.wall.size() && free; ++k) {
    const Scene::Wall& w = s.wall[k];
    const bool round = w.shape == Shape::sphere || w.shape == Shape::cylinder;
    if (w.shape == Shape::points || (round && w.side == Side::inside))
      warn(fmt::format("wall[{}].shape", k),
           fmt::format("free bodies do not collide with {}, {}: it stops the fluid only",
                       s.wall_names()[2 * std::size_t(s.dimension()) + k],
                       w.shape == Shape::points ? "a wall of points"
                                                : "a round wall with side = \"inside\""));
  }
  return list;
}

}  // namespace freshet
