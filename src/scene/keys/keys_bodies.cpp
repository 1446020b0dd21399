// SPDX-License-Identifier: MIT
#include "scene/keys/keys_bodies.h"

#include "scene/keys/keys_output.h"

namespace freshet {
namespace {

void moved_keys(KeyVisitor& v, Scene::Body& b) {
  v.texts("position", b.position,
          {.unit = "m",
           .text = "how far a `moved` body is from its place at the start, a function of t [s] for "
                   "each axis: `[\"0.1*sin(2*pi*t)\", \"0\"]`, 0 at t = 0",
           .fallback = "none"});
  v.text(
      "angle", b.angle,
      {.unit = "°",
       .text = "how far a `moved` body has turned about `pivot` and `turn_axis`, a function of t "
               "[s]: `\"90*t\"`, 0 at t = 0",
       .fallback = "none"});
  v.text("path", b.path,
         {.unit = "",
          .text = "key frames of a `moved` body from a file: `*.csv` whose first line names the "
                  "columns time [s], x, y, z [m] and angle [°]; relative to the scene",
          .fallback = "none"});
  v.choice("interpolation", b.interpolation, interpolation_words,
           {.unit = "",
            .text = "between key frames: `smooth` in place and speed, at rest at both ends, or "
                    "`linear`"});
  v.vector("pivot", b.pivot,
           {.unit = "m",
            .text = "the point that `angle` turns a `moved` body about, as it stands at the start",
            .fallback = "its centre of mass"});
  v.vector("turn_axis", b.turn_axis,
           {.unit = "",
            .text = "the direction that `angle` and `angular_velocity` turn about, "
                    "counterclockwise as seen against it (3D)",
            .fallback = "along z"});
}

void free_keys(KeyVisitor& v, Scene::Body& b) {
  v.number("density", b.density,
           {.unit = density_unit,
            .text = "of a `free` body; it or `mass`",
            .min = 0,
            .above = true,
            .fallback = "none"});
  v.number("mass", b.mass,
           {.unit = "kg; kg/m in 2D",
            .text = "of a `free` body, spread evenly; it or `density`",
            .min = 0,
            .above = true,
            .fallback = "none"});
  v.vector("velocity", b.velocity,
           {.unit = "m/s", .text = "of a `free` body at the start", .fallback = "at rest"});
  v.number("angular_velocity", b.angular_velocity,
           {.unit = "rad/s", .text = "of a `free` body about `turn_axis` at the start"});
  v.number("restitution", b.restitution,
           {.unit = "",
            .text = "share of the speed that is left after bodies bounce: the product of both",
            .min = 0,
            .max = 1});
  v.number("friction", b.friction,
           {.unit = "",
            .text = "coefficient between bodies that touch: the product of both; walls have 0.5",
            .min = 0,
            .max = 10});
}

void key_frame_keys(KeyVisitor& v, Scene::Body::Key& k) {
  v.number("time", k.time, {.unit = "s", .text = "when the body is there", .required = true});
  v.vector("translation", k.translation,
           {.unit = "m", .text = "from the place at the start", .fallback = "none"});
  v.number("angle", k.angle, {.unit = "°", .text = "about `pivot` and `turn_axis`"});
}

void joint_keys(KeyVisitor& v, Scene::Joint& j) {
  v.text("body", j.body, {.unit = "", .text = "name of a `free` body", .required = true});
  v.text("other", j.other,
         {.unit = "", .text = "name of the body that it hangs on", .fallback = "the world"});
  v.vector("point", j.point,
           {.unit = "m", .text = "where the hinge is at the start", .required = true});
  v.vector("axis", j.axis,
           {.unit = "", .text = "of the hinge, at the start (3D)", .fallback = "along z"});
  v.number("motor_speed", j.motor_speed,
           {.unit = "rad/s",
            .text = "what a motor turns `body` at, about `axis`",
            .fallback = "no motor"});
  v.number("motor_torque", j.motor_torque,
           {.unit = "N m; N in 2D",
            .text = "the most that the motor gives",
            .min = 0,
            .above = true,
            .fallback = "none; a motor needs it"});
}

}  // namespace

void body_keys(KeyVisitor& v, Scene& s) {
  v.tables("body",
           "A rigid body: `[body]` for one, `[[body]]` for several. docs/bodies.md tells "
           "how they work.",
           s.body, [&](Scene::Body& b) {
             v.text("name", b.name,
                    {.unit = "", .text = "what joints and tables call it", .fallback = "body[k]"});
             region_keys(v, b, Words(shape_words).first(6),
                         {.unit = "",
                          .text = "`box`, `sphere` (in 2D a disc), `cylinder` (3D) or the `mesh` "
                                  "of a file (3D), where it stands at the start"},
                         {.unit = "", .text = "fluid is `outside` of a body"});
             file_keys(v, b);
             v.choice("motion", b.motion, motion_words,
                      {.unit = "",
                       .text = "`fixed`, `moved` as position, angle, key frames or path say, or "
                               "`free`: by the fluid, gravity and what it touches"});
             v.choice(
                 "slip", b.slip, slip_words,
                 {.unit = "", .text = "`no_slip`: fluid sticks to it; `free_slip`: it glides"});
             moved_keys(v, b);
             free_keys(v, b);
             v.tables("key", "A key frame of a `moved` body, `[[body.key]]`, below it.", b.key,
                      [&](Scene::Body::Key& k) { key_frame_keys(v, k); });
           });
  v.tables("joint", "A hinge of a `free` body: `[joint]` for one, `[[joint]]` for several.",
           s.joint, [&](Scene::Joint& j) { joint_keys(v, j); });
}

}  // namespace freshet
