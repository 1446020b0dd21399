// SPDX-License-Identifier: MIT
/// Free bodies: mass, inertia and locked axes.
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>

#include "scene/check/findings.h"
#include "scene/keys/keys.h"
#include "scene/model/body_shape.h"
#include "scene/model/solid_of.h"

namespace freshet {
namespace {

bool check_mass(const Scene::Body& b, const std::string& at, Findings& out) {
  if (!moves_free_bodies())
    out.error(at + "motion",
              "body.motion is \"free\", which needs Bullet, and this Freshet was built without it; "
              "install libbullet-dev and rebuild");
  if (b.side == Side::inside && !b.mass)
    out.error(at + (b.density ? "density" : "motion"),
              b.density ? "body.density is set, and body.side is \"inside\": a tank has no "
                          "thickness; set body.mass instead, the mass of the empty tank"
                        : "body.motion is \"free\", and the mass is missing; set body.mass, the "
                          "mass of the empty tank");
  else if (!b.density && !b.mass)
    out.error(at + "motion",
              "body.motion is \"free\", and the mass is missing; set body.density or body.mass");
  else if (b.density && b.mass)
    out.error(at + "mass", "body.density and body.mass are both set; keep one of them");
  else return moves_free_bodies();
  return false;
}

/// Whether a symmetric matrix is positive definite [Sylvester].
bool is_positive(const double (&m)[3][3]) {
  const double minor = m[0][0] * m[1][1] - m[0][1] * m[1][0];
  const double det = minor * m[2][2] - m[0][0] * m[1][2] * m[2][1] - m[0][2] * m[2][0] * m[1][1] +
                     m[0][1] * m[1][2] * m[2][0] + m[0][2] * m[1][0] * m[2][1];
  return m[0][0] > 0 && minor > 0 && det > 0;
}

/// Whether no principal moment exceeds the sum of the other two, but for rounding: the matrix of
/// second moments, (trace/2) I - inertia, has no negative eigenvalue.
bool has_second_moments(const double (&inertia)[3][3]) {
  constexpr double rounding = 1e-3;
  const double trace = inertia[0][0] + inertia[1][1] + inertia[2][2];
  double second[3][3];
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j)
      second[i][j] = (i == j ? (0.5 + rounding) * trace : 0) - inertia[i][j];
  return is_positive(second);
}

bool check_inertia(const Scene& s, const Scene::Body& b, const std::string& at, Findings& out) {
  const std::size_t n = b.inertia.size();
  const bool flat = s.dimension() == 2;
  if (n == 0) {
    if (b.center_of_mass.empty()) return true;
    out.error(at + "center_of_mass",
              "body.center_of_mass is set, and body.inertia is missing: a mass that is not spread "
              "evenly has a moment of inertia of its own; set it");
    return false;
  }
  if (flat ? n != 1 : n != 3 && n != 6) {
    out.error(at + "inertia", fmt::format("body.inertia has {} numbers; it must have {}", n,
                                          flat ? "1 in 2D" : "3 or 6 in 3D"));
    return false;
  }
  const BodyShape shape = body_shape(b);
  const char* fault = nullptr;
  if (flat) {
    if (!(b.inertia[0] > 0)) fault = "it must be greater than 0";
  } else if (!is_positive(shape.inertia)) {
    fault = "its principal moments must be greater than 0";
  } else if (!has_second_moments(shape.inertia)) {
    fault = "none of its principal moments may exceed the sum of the other two";
  }
  if (!fault) return true;
  out.error(at + "inertia",
            flat ? fmt::format("body.inertia is {:g}; {}", b.inertia[0], fault)
                 : fmt::format("body.inertia is [{:g}], which no body has: {}; check its numbers "
                               "and their order",
                               fmt::join(b.inertia, ", "), fault));
  return false;
}

bool check_lock(const Scene& s, const Scene::Body& b, const std::string& at, Findings& out) {
  const auto unit = s.dimension() == 3 ? unit_of<3>(b.turn_axis) : Vec<3, double>{0, 0, 1};
  const double omega[] = {unit.x, unit.y, unit.z};
  bool good = true;
  for (const Freedom f : b.lock) {
    const auto k = std::size_t(f);
    const char* word = freedom_words[k];
    if (s.dimension() == 2 && k >= 2 && k < 5) {
      out.error(at + "lock", fmt::format("body.lock has \"{0}\", and the scene is in 2D, where a "
                                         "body has \"x\", \"y\" and \"rotation_z\"; remove \"{0}\"",
                                         word));
      good = false;
      continue;
    }
    const bool turns = k >= 3;
    if ((turns ? b.angular_velocity * omega[k - 3] : b.velocity[k]) == 0) continue;
    const char* key = turns ? "angular_velocity" : "velocity";
    out.error(at + key, fmt::format("body.{} moves the body {} {}, which body.lock holds; set it "
                                    "to 0 there, or remove \"{}\" from body.lock",
                                    key, turns ? "about" : "along", axis_names[k % 3], word));
    good = false;
  }
  return good;
}

}  // namespace

bool check_free(const Scene& s, const Scene::Body& b, const std::string& at, Findings& out) {
  return check_mass(b, at, out) && check_inertia(s, b, at, out) && check_lock(s, b, at, out);
}

}  // namespace freshet
