// SPDX-License-Identifier: MIT
#include <algorithm>
#include <set>

#include "scene/check/findings.h"
#include "scene/check/names.h"
#include "scene/keys/keys.h"
#include "scene/model/loaded_mesh.h"
#include "scene/model/setup.h"
#include "scene/model/solid_of.h"

namespace freshet {
namespace {

constexpr std::size_t most_walls = 1000;

bool is_sampled(WallMethod m) {
  return m == WallMethod::akinci2012 || m == WallMethod::adami2012 || m == WallMethod::monaghan2009;
}

bool has_slip(WallMethod m) {
  return m == WallMethod::ghost || m == WallMethod::akinci2012 || m == WallMethod::adami2012;
}

const char* word_of(WallMethod m) { return method_words[int(m)]; }

/// Whether the solver supports the method. `flat`: the wall could be "ghost".
bool check_solver(const Scene& s, WallMethod m, const std::string& key, const std::string& name,
                  bool flat, Findings& out) {
  const SolverMethod& solver = s.method();
  const bool unknown = is_sampled(m) && !solver.has_boundary_particles();
  if (unknown)
    out.unsupported(key, fmt::format("{} is \"{}\", and {} supports \"open\", \"reflection\" and "
                                     "\"ghost\" only; choose one, or another solver.name",
                                     name, word_of(m), solver.name));
  const bool extrapolates = solver.incompressible() && m == WallMethod::adami2012;
  if (extrapolates)
    out.unsupported(key,
                    fmt::format("{} is \"adami2012\", which needs an equation of state, and {} has "
                                "none; choose \"akinci2012\"{}",
                                name, solver.name, flat ? " or \"ghost\"" : ""));
  return !extrapolates && !unknown;
}

/// Reports keys that the method does not read.
void check_surface_keys(bool reflects, bool slips, const std::string& at, const std::string& name,
                        Findings& out) {
  if (!reflects)
    out.unused(at + "restitution", name + ".restitution",
               "only \"reflection\" reads it; remove it, or choose that method");
  if (!slips)
    out.unused(at + "slip", name + ".slip",
               "only \"ghost\", \"akinci2012\" and \"adami2012\" read it; remove it, or choose one "
               "of these methods");
}

/// The velocity of a surface that slides along itself.
void check_velocity(const Scene& s, std::size_t k, const std::string& at, Findings& out) {
  const Scene::Wall& w = s.wall[k];
  if (w.velocity.empty()) return;
  if (s.wall_method(k) != WallMethod::adami2012)
    out.error(at + "velocity", fmt::format("wall.velocity needs \"adami2012\", and wall.method is "
                                           "\"{}\"; choose \"adami2012\", or use a moved [[body]]",
                                           word_of(s.wall_method(k))));
  else if (w.slip == Slip::free_slip)
    out.error(at + "velocity",
              "wall.velocity drags the fluid along, and wall.slip = "
              "\"free_slip\" prevents that; remove one of them");
  else if (s.viscosity_method() == ViscosityMethod::weiler2018)
    out.error(at + "velocity",
              "solver.viscosity_method = \"weiler2018\" needs walls of "
              "\"adami2012\" at rest; choose \"morris1997\" or "
              "\"monaghan2005\", or remove wall.velocity");
}

/// Whether the method suits the shape of the wall and the solver.
bool check_method_of(const Scene& s, std::size_t k, const std::string& at, Findings& out) {
  const Scene::Wall& w = s.wall[k];
  const WallMethod m = s.wall_method(k);
  const std::string key = at + "method";
  const bool box_inside = w.shape == Shape::box && w.side == Side::inside;
  if (w.shape == Shape::points && !s.method().has_boundary_particles())
    out.error(at + "shape",
              fmt::format("wall.shape is \"points\", which needs boundary particles, and "
                          "{} has none; choose another shape or another solver.name",
                          s.method().name));
  else if (w.shape == Shape::points && !is_sampled(m))
    out.error(key, fmt::format("wall.method is \"{}\", and points need \"akinci2012\"{} or "
                               "\"monaghan2009\"; choose one",
                               word_of(m), s.method().incompressible() ? "" : ", \"adami2012\""));
  else if (is_mesh(w) && !is_sampled(m))
    out.error(key,
              fmt::format("wall.method is \"{}\", and {} needs boundary particles; choose "
                          "\"akinci2012\"{} or \"monaghan2009\"{}",
                          word_of(m),
                          w.shape == Shape::box    ? "a turned box"
                          : w.shape == Shape::mesh ? "a mesh"
                                                   : "a polygon",
                          s.method().incompressible() ? "" : ", \"adami2012\"",
                          s.method().has_boundary_particles()
                              ? ""
                              : fmt::format(", and another solver.name than {}", s.method().name)));
  else if (w.shape == Shape::mesh && m == WallMethod::adami2012 && w.loaded &&
           !w.loaded->condition.closed())
    out.error(key,
              "wall.method is \"adami2012\", which needs a solid behind the surface, and the mesh "
              "has holes; close the mesh, or choose \"akinci2012\" or \"monaghan2009\"");
  else if (m == WallMethod::open)
    out.error(key,
              "wall.method is \"open\", which has no effect; remove the wall or choose "
              "another method");
  else if (m == WallMethod::ghost && !box_inside && w.shape != Shape::plane)
    out.error(key,
              "wall.method is \"ghost\", which needs a flat wall: a plane, or a box with "
              "side = \"inside\"; choose one of these or another method");
  else return check_solver(s, m, key, "wall.method", box_inside || w.shape == Shape::plane, out);
  return false;
}

/// A wall with boundary particles must be thick enough to hold one.
bool check_thickness(const Scene& s, std::size_t k, const std::string& at, Findings& out) {
  const Scene::Wall& w = s.wall[k];
  if (!is_sampled(s.wall_method(k)) || w.side == Side::inside) return true;
  const auto too_thin = [&](const char* key, double length, double least) {
    if (length >= least * (1 - 1e-6)) return false;
    out.error(at + key,
              fmt::format("wall.{} is {}, and its boundary particles need at least {:.6g} "
                          "at spacing {}; make it larger or the spacing smaller",
                          key, length, least, s.particles.spacing));
    return true;
  };
  const bool round = w.shape == Shape::sphere || w.shape == Shape::cylinder;
  if (round && too_thin("radius", w.radius, s.particles.spacing / 2)) return false;
  return w.shape != Shape::cylinder || !too_thin("length", w.length, s.particles.spacing);
}

/// Names are headers of table columns: plain and unique.
void check_names(const Scene& s, Findings& out) {
  const std::vector<std::string> names = s.wall_names();
  const std::size_t sides = names.size() - s.wall.size();
  std::set<std::string> taken(names.begin(), names.begin() + std::ptrdiff_t(sides));
  for (std::size_t k = 0; k < s.wall.size(); ++k) {
    const std::string& name = names[sides + k];
    const std::string key = fmt::format("wall[{}].name", k);
    if (!names_column(name))
      out.error(key,
                "wall.name has a comma, a quote or an invisible character, which tables do not "
                "allow; use letters, digits and _");
    else if (!taken.insert(name).second)
      out.error(key, fmt::format("wall.name is \"{}\", which another wall or a side of the domain "
                                 "has; choose another name",
                                 name));
  }
}

bool check_wall(const Scene& s, std::size_t k, Findings& out) {
  const Scene::Wall& w = s.wall[k];
  const std::string at = fmt::format("wall[{}].", k);
  if (w.shape == Shape::lattice) {
    out.error(at + "shape",
              "wall.shape is \"lattice\"; a wall must be a box, sphere, cylinder, plane, "
              "mesh, polygon or points; choose one");
    return false;
  }
  const WallMethod m = s.wall_method(k);
  check_surface_keys(m == WallMethod::reflection, has_slip(m), at, "wall", out);
  check_velocity(s, k, at, out);
  const bool good = check_method_of(s, k, at, out);
  if (!check_region(s, {w, at, "wall"}, out) || !check_thickness(s, k, at, out)) return false;
  return (w.shape != Shape::points || check_points(s, {w, at, "wall"}, out)) && good;
}

}  // namespace

bool check_walls(const Scene& s, Findings& out) {
  if (s.wall.size() > most_walls) {
    out.error("wall",
              fmt::format("there are {} walls; at most {} are allowed", s.wall.size(), most_walls));
    return false;
  }
  check_names(s, out);
  bool good = true;
  for (std::size_t k = 0; k < s.wall.size(); ++k) good &= check_wall(s, k, out);
  return good;
}

void check_sides(const Scene& s, Findings& out) {
  static constexpr const char* names[] = {"x_min", "x_max", "y_min", "y_max", "z_min", "z_max"};
  bool reflects = false, slips = false, shared = false, told = false;
  for (int side = 0; side < 6; ++side) {
    const std::string name = fmt::format("walls.{}", names[side]);
    const char axis = axis_names[side / 2];
    if (side >= 2 * s.dimension()) {
      out.unused(name, name, fmt::format("the domain has no {}; remove it", axis));
      continue;
    }
    if (s.periodic(side / 2)) {
      out.unused(name, name, fmt::format("the domain is periodic in {}; remove it", axis));
      continue;
    }
    const WallMethod m = s.side_method(side);
    reflects |= m == WallMethod::reflection;
    slips |= has_slip(m);
    const bool own = out.given(name);
    const std::string key = own ? name : "walls.method";
    if (own || !told) told |= !check_solver(s, m, key, key, true, out) && !own;
    shared |= !own;
  }
  if (!shared && !s.body.empty() && body_method(s) == WallMethod::adami2012)
    check_solver(s, WallMethod::adami2012, "walls.method", "walls.method", false, out);
  else if (!shared)
    out.unused("walls.method", "walls.method",
               "every side that is not periodic has a method of its own; remove it");
  check_surface_keys(reflects, slips, "walls.", "walls", out);
}

}  // namespace freshet
