// SPDX-License-Identifier: MIT
/// Rigid bodies and joints: the keys of each kind of motion, and their places.
#include <algorithm>
#include <cmath>

#include "scene/check/findings.h"
#include "scene/keys/keys.h"
#include "scene/model/body_motion.h"
#include "scene/model/body_shape.h"
#include "scene/model/expressions.h"
#include "scene/model/setup.h"

namespace freshet {
namespace {

constexpr std::size_t most_bodies = 1000;

std::string at_body(std::size_t k) { return fmt::format("body[{}].", k); }

/// Bodies consist of boundary particles with a velocity, which the solver must support.
bool check_solver(const Scene& s, Findings& out) {
  if (!s.method().has_boundary_particles()) {
    out.error("body[0]", fmt::format("bodies need boundary particles, which {} does not "
                                     "support; choose another solver.name",
                                     s.method().name));
    return false;
  }
  const auto refuse = [&](WallMethod m, const std::string& key) {
    if (m != WallMethod::ghost) return true;
    out.error(key, fmt::format("\"ghost\" walls do not work with bodies; choose {}\"akinci2012\", "
                               "\"monaghan2009\", \"reflection\" or \"open\"",
                               s.method().incompressible() ? "" : "\"adami2012\", "));
    return false;
  };
  const ViscosityMethod felt = s.method().viscosity;
  if (s.viscosity_method() != felt) {
    out.error(
        "solver.viscosity_method",
        fmt::format("bodies support only the viscosity \"{}\" of {}; choose it, or remove the "
                    "bodies",
                    force_words("solver.viscosity_method")[std::size_t(felt)], s.method().name));
    return false;
  }
  if (s.solver.surface_tension_method != SurfaceTensionMethod::none) {
    out.error("solver.surface_tension_method",
              "bodies do not support surface tension; choose \"none\", or remove the bodies");
    return false;
  }
  const std::vector<std::string> names = s.wall_names();
  for (int side = 0; side < 2 * s.dimension(); ++side) {
    const std::string own = "walls." + names[std::size_t(side)];
    if (!s.periodic(side / 2) &&
        !refuse(s.side_method(side), out.given(own) ? own : "walls.method"))
      return false;
  }
  for (std::size_t k = 0; k < s.wall.size(); ++k)
    if (!refuse(s.wall_method(k), fmt::format("wall[{}].method", k))) return false;
  return true;
}

/// Reports keys that the motion does not read.
void check_motion_keys(const Scene::Body& b, const std::string& at, Findings& out) {
  const char* is = motion_words[int(b.motion)];
  const auto unused = [&](BodyMotion needed, std::initializer_list<const char*> keys) {
    if (b.motion == needed) return;
    for (const char* key : keys)
      out.unused(at + key, fmt::format("body.{}", key),
                 fmt::format("body.motion is \"{}\"; remove it, or set body.motion = \"{}\"", is,
                             motion_words[int(needed)]));
  };
  unused(BodyMotion::moved, {"position", "angle", "key", "path", "interpolation", "pivot"});
  unused(BodyMotion::free,
         {"density", "mass", "center_of_mass", "inertia", "lock", "velocity", "angular_velocity"});
  if (b.motion == BodyMotion::fixed)
    for (const char* key : {"turn_axis"})
      out.unused(at + key, fmt::format("body.{}", key),
                 "body.motion is \"fixed\"; remove it, or set body.motion = \"moved\"");
}

bool check_axis(const Scene& s, const std::string& key, const std::string& name, const Vector& axis,
                Findings& out) {
  if (s.dimension() == 2)
    out.unused(key, name, "the scene is in 2D, where the axis is always z; remove it");
  else if (std::all_of(axis.begin(), axis.end(), [](double a) { return a == 0; })) {
    out.error(key,
              fmt::format("{} is 0 and has no direction; set one, for example [0, 0, 1]", name));
    return false;
  }
  return true;
}

bool check_functions(const Scene& s, const Scene::Body& b, const std::string& at, Findings& out) {
  const auto look = [&](const std::vector<std::string>& functions, const char* key) {
    if (functions.empty()) return true;
    if (const auto fault = fault_in(functions)) {
      out.error(at + key, fmt::format("body.{} {}", key, *fault));
      return false;
    }
    if (!Expressions(functions).depends_on_place()) return true;
    out.error(at + key, fmt::format("body.{} depends on x, y or z; it must be a function of t "
                                    "only",
                                    key));
    return false;
  };
  if (!b.position.empty() && b.position.size() != std::size_t(s.dimension())) {
    out.error(at + "position",
              fmt::format("body.position has {} functions; it must have {}, one per axis",
                          b.position.size(), s.dimension()));
    return false;
  }
  const bool position = look(b.position, "position");
  return look(b.angle.empty() ? std::vector<std::string>() : std::vector{b.angle}, "angle") &&
         position;
}

bool check_key_frames(const Scene::Body& b, const std::string& at, Findings& out) {
  if (b.key.size() == 1) {
    out.error(at + "key[0]",
              "there is one key frame; a motion needs at least two; add another [[body.key]]");
    return false;
  }
  for (std::size_t k = 1; k < b.key.size(); ++k)
    if (!(b.key[k].time > b.key[k - 1].time)) {
      out.error(fmt::format("{}key[{}].time", at, k),
                fmt::format("the time of this key frame, {:g} s, is not after that of the previous "
                            "one, {:g} s; sort them by time",
                            b.key[k].time, b.key[k - 1].time));
      return false;
    }
  return true;
}

bool check_path(const Scene& s, const Scene::Body& b, const std::string& at, Findings& out) {
  try {
    read_body_path(b.path, s.dimension());
    return true;
  } catch (const Error& e) {
    for (const Diagnostic& d : e.diagnostics())
      if (d.place == b.path)
        out.error(at + "path", fmt::format("body.path is \"{}\": {}", b.path, d.message));
      else out.list.push_back(d);
    return false;
  }
}

/// The motion must be 0 at the start, and finite at all times.
bool check_course(const Scene& s, const Scene::Body& b, const std::string& at, Findings& out) {
  const PrescribedMotion motion(b, s.dimension());
  const bool functions = !b.position.empty() || !b.angle.empty();
  const Displacement start = motion.at(0);
  for (std::size_t j = 0; j < 4; ++j) {
    const std::string key = functions        ? (j == 3 ? "angle" : "position")
                            : b.path.empty() ? "key[0]"
                                             : "path";
    for (int k = 0; k <= 200; ++k)
      if (const double t = s.time.end * k / 200; !std::isfinite(motion.at(t).value[j])) {
        out.error(
            at + key,
            fmt::format("body.{} is NaN or infinite at t = {:g} s; fix the expression", key, t));
        return false;
      }
    const double enough = j == 3 ? 1e-6 : 1e-6 * s.particles.spacing;
    if (std::abs(start.value[j]) <= enough) continue;
    out.error(
        at + key,
        fmt::format("the motion displaces the body by {:.4g} {} at t = 0; it must be 0 there; "
                    "change the motion, or move the shape",
                    j == 3 ? start.value[j] * 180 / 3.14159265358979 : start.value[j],
                    j == 3 ? "°" : "m"));
    return false;
  }
  return true;
}

bool check_moved(const Scene& s, const Scene::Body& b, const std::string& at, Findings& out) {
  const bool functions = !b.position.empty() || !b.angle.empty();
  const int given = functions + !b.key.empty() + !b.path.empty();
  if (given != 1) {
    out.error(at + "motion",
              fmt::format("body.motion is \"moved\", and {} set; set one of these: body.position "
                          "and body.angle, [[body.key]] frames, or body.path",
                          given == 0 ? "no motion is" : "more than one motion is"));
    return false;
  }
  if (functions)
    out.unused(at + "interpolation", "body.interpolation",
               "the motion is a function; remove it, or set key frames");
  const bool good = functions        ? check_functions(s, b, at, out)
                    : b.path.empty() ? check_key_frames(b, at, out)
                                     : check_path(s, b, at, out);
  return good && check_course(s, b, at, out);
}

bool check_thickness(const Scene& s, const Scene::Body& b, const std::string& at, Findings& out) {
  if (b.side == Side::inside) return true;  // the particles of a tank lie around its shape
  const double spacing = s.particles.spacing;
  const auto thick = [&](const char* key, double length, double least) {
    if (length >= least * (1 - 1e-6)) return true;
    out.error(
        at + key,
        fmt::format("the body is too thin: {:.6g} m, and its particles need at least {:.6g} m "
                    "at spacing {}; make it thicker or the spacing smaller",
                    length, least, spacing));
    return false;
  };
  if (b.shape == Shape::box)
    for (std::size_t k = 0; k < b.min.size(); ++k)
      if (!thick("max", b.max[k] - b.min[k], spacing)) return false;
  const bool round = b.shape == Shape::sphere || b.shape == Shape::cylinder;
  if (round && !thick("radius", b.radius, spacing / 2)) return false;
  return b.shape != Shape::cylinder || thick("length", b.length, spacing);
}

bool check_body(const Scene& s, std::size_t k, Findings& out) {
  const Scene::Body& b = s.body[k];
  const std::string at = at_body(k);
  if (b.shape == Shape::plane || b.shape == Shape::points || b.shape == Shape::lattice) {
    out.error(
        at + "shape",
        fmt::format("body.shape is \"{}\"; a body must be a box, sphere, cylinder, polygon or "
                    "mesh; choose one",
                    shape_words[int(b.shape)]));
    return false;
  }
  check_motion_keys(b, at, out);
  const bool turns = check_axis(s, at + "turn_axis", "body.turn_axis", b.turn_axis, out);
  if (!check_region(s, {b, at, "body"}, out) || !check_thickness(s, b, at, out) ||
      !check_body_reach(s, k, out))
    return false;
  if (b.motion == BodyMotion::moved) return check_moved(s, b, at, out) && turns;
  return (b.motion == BodyMotion::fixed || (turns && check_free(s, b, at, out))) && turns;
}

bool hinged_to_free(const Scene& s, const Scene::Joint& j) {
  for (std::size_t k = 0; k < s.body.size(); ++k)
    if (s.body_name(k) == j.other) return s.body[k].motion == BodyMotion::free;
  return false;
}

bool check_joint(const Scene& s, std::size_t k, Findings& out) {
  const Scene::Joint& j = s.joint[k];
  const std::string at = fmt::format("joint[{}].", k);
  const auto find = [&](const std::string& name, const char* key) {
    return find_body(s, name, at + key, fmt::format("joint.{}", key), out);
  };
  bool good = check_axis(s, at + "axis", "joint.axis", j.axis, out);
  const Scene::Body* body = find(j.body, "body");
  good &= body && (j.other.empty() || find(j.other, "other"));
  if (body && body->motion != BodyMotion::free) {
    out.error(at + "body", fmt::format("joint.body is \"{}\", which is {}; a joint needs a free "
                                       "body; name a body with motion = \"free\"",
                                       j.body, motion_words[int(body->motion)]));
    good = false;
  }
  if (body && !body->lock.empty() && !hinged_to_free(s, j)) {
    out.error(
        at + "body",
        fmt::format("joint.body is \"{}\", which has body.lock; a hinge to the world, or to a "
                    "body that is not free, leaves its rotation only; remove body.lock or "
                    "the joint",
                    j.body));
    good = false;
  }
  if (j.body == j.other) {
    out.error(at + "other",
              fmt::format("joint.other is \"{}\", the same as joint.body; name another "
                          "body, or remove it to hinge the body to the world",
                          j.other));
    good = false;
  }
  if (j.point.size() != s.domain.max.size()) {
    out.error(at + "point",
              "joint.point is missing: position of the hinge at the start (m); add it");
    good = false;
  }
  if (j.motor_speed && !j.motor_torque)
    out.error(at + "motor_speed",
              "joint.motor_speed needs joint.motor_torque, the maximum torque of "
              "the motor; add it");
  if (!j.motor_speed)
    out.unused(at + "motor_torque", "joint.motor_torque",
               "there is no motor; set joint.motor_speed (0 for a brake), or remove it");
  return good;
}

/// A free tank collides as its convex hull, so that nothing solid can be in it.
bool check_free_tanks(const Scene& s, Findings& out) {
  for (std::size_t k = 0; k < s.body.size(); ++k) {
    const Scene::Body& b = s.body[k];
    if (b.side == Side::outside || b.motion != BodyMotion::free || s.body.size() == 1) continue;
    out.error(
        at_body(k) + "motion",
        fmt::format("{} is a free tank, and there is another body, {}: a free tank collides as "
                    "if it were solid, so that no body can be in it; set body.motion = "
                    "\"moved\" or \"fixed\" for the tank, or remove the other bodies",
                    s.body_name(k), s.body_name(k == 0 ? 1 : 0)));
    return false;
  }
  return true;
}

}  // namespace

bool check_bodies(const Scene& s, Findings& out) {
  if (s.body.size() > most_bodies) {
    out.error("body", fmt::format("there are {} bodies; at most {} are allowed", s.body.size(),
                                  most_bodies));
    return false;
  }
  bool good = s.body.empty() || check_solver(s, out);
  check_body_names(s, out);
  for (std::size_t k = 0; k < s.body.size(); ++k) good &= check_body(s, k, out);
  good &= check_free_tanks(s, out);
  for (std::size_t k = 0; k < s.joint.size(); ++k) good &= check_joint(s, k, out);
  return good;
}

}  // namespace freshet
