// SPDX-License-Identifier: MIT
#include "scene/keys/keys_bodies.h"

#include "scene/keys/keys_output.h"

namespace freshet {
namespace {

void moved_keys(KeyVisitor& v, Scene::Body& b) {
  v.texts("position", b.position,
          {.unit = "m",
           .text = "displacement of a `moved` body from its start: one function of t [s] per axis, "
                   "0 at t = 0, such as `[\"0.1*sin(2*pi*t)\", \"0\"]`",
           .fallback = "none"});
  v.text("angle", b.angle,
         {.unit = "°",
          .text = "rotation of a `moved` body about `pivot` and `turn_axis`: a function of t [s], "
                  "0 at t = 0, such as `\"90*t\"`",
          .fallback = "none"});
  v.text("path", b.path,
         {.unit = "",
          .text = "file of key frames of a `moved` body, relative to the scene: a `*.csv` whose "
                  "first line names the columns time [s], x, y, z [m] and angle [°]",
          .fallback = "none"});
  v.choice("interpolation", b.interpolation, interpolation_words,
           {.unit = "",
            .text = "between key frames: `linear`, or `smooth` in position and speed, with rest at "
                    "both ends"});
  v.vector("pivot", b.pivot,
           {.unit = "m",
            .text = "centre of rotation of a `moved` body by `angle`, at the start",
            .fallback = "its centre of mass"});
  v.vector("turn_axis", b.turn_axis,
           {.unit = "",
            .text = "axis of `angle` and `angular_velocity`, counterclockwise when it points at "
                    "the viewer (3D)",
            .fallback = "along z"});
}

void free_keys(KeyVisitor& v, Scene::Body& b) {
  v.number("density", b.density,
           {.unit = density_unit,
            .text = "density of a `free` body; set it or `mass`",
            .min = 0,
            .above = true,
            .fallback = "none"});
  v.number("mass", b.mass,
           {.unit = mass_unit,
            .text = "mass of a `free` body; set it or `density`",
            .min = 0,
            .above = true,
            .fallback = "none"});
  v.vector("center_of_mass", b.center_of_mass,
           {.unit = "m",
            .text = "centre of mass of a `free` body at the start; needs `inertia`",
            .fallback = "of an even density"});
  static constexpr std::size_t diagonal_or_full[] = {3, 6};
  v.components("inertia", b.inertia, diagonal_or_full,
               {.unit = inertia_unit,
                .text = "moment of inertia of a `free` body about its centre of mass: in 2D a "
                        "number; in 3D `[xx, yy, zz]` or `[xx, yy, zz, xy, xz, yz]`, the elements "
                        "of the tensor along the axes of space at the start",
                .fallback = "of an even density"});
  v.choices("lock", b.lock, freedom_words,
            {.unit = "",
             .text = "coordinates of the centre of mass and rotations about the axes of space that "
                     "a `free` body keeps; in 2D `x`, `y` and `rotation_z`"});
  v.vector("velocity", b.velocity,
           {.unit = "m/s", .text = "initial velocity of a `free` body", .fallback = "at rest"});
  v.number(
      "angular_velocity", b.angular_velocity,
      {.unit = "rad/s", .text = "initial angular velocity of a `free` body about `turn_axis`"});
  v.number("restitution", b.restitution,
           {.unit = "",
            .text = "fraction of the speed that remains after an impact: the product of both "
                    "bodies' values; walls have 1",
            .min = 0,
            .max = 1});
  v.number(
      "friction", b.friction,
      {.unit = "",
       .text =
           "coefficient of friction in a contact: the product of both bodies' values; walls have 1",
       .min = 0,
       .max = 10});
}

void key_frame_keys(KeyVisitor& v, Scene::Body::Key& k) {
  v.number("time", k.time, {.unit = "s", .text = "time of the key frame", .required = true});
  v.vector("translation", k.translation,
           {.unit = "m", .text = "displacement from the start", .fallback = "none"});
  v.number("angle", k.angle, {.unit = "°", .text = "rotation about `pivot` and `turn_axis`"});
}

void joint_keys(KeyVisitor& v, Scene::Joint& j) {
  v.text("body", j.body, {.unit = "", .text = "name of a `free` body", .required = true});
  v.text("other", j.other,
         {.unit = "", .text = "name of the body that it is hinged to", .fallback = "the world"});
  v.vector("point", j.point,
           {.unit = "m", .text = "position of the hinge at the start", .required = true});
  v.vector("axis", j.axis,
           {.unit = "", .text = "axis of the hinge at the start (3D)", .fallback = "along z"});
  v.number("motor_speed", j.motor_speed,
           {.unit = "rad/s",
            .text = "speed of a motor that turns `body` about `axis`",
            .fallback = "no motor"});
  v.number("motor_torque", j.motor_torque,
           {.unit = torque_unit,
            .text = "maximum torque of the motor",
            .min = 0,
            .above = true,
            .fallback = "none; required for a motor"});
}

}  // namespace

void body_keys(KeyVisitor& v, Scene& s) {
  v.tables(
      "body",
      "A rigid body: `[body]` for one, `[[body]]` for several. docs/bodies.md explains bodies.",
      s.body, [&](Scene::Body& b) {
        v.text("name", b.name,
               {.unit = "", .text = "name in joints and tables", .fallback = "body[k]"});
        region_keys(v, b, Words(shape_words).first(7),
                    {.unit = "",
                     .text = "shape and place at the start: `box`, `sphere` (in 2D a disc), "
                             "`cylinder` (3D), `polygon` (2D) or the `mesh` of a file (3D)"},
                    {.unit = "",
                     .text = "side of the fluid: `outside` of an obstacle, `inside` of a tank"});
        file_keys(v, b);
        v.choice("motion", b.motion, motion_words,
                 {.unit = "",
                  .text = "`fixed`; `moved` by `position`, `angle`, key frames or `path`; or "
                          "`free`, moved by the fluid, gravity and contacts"});
        v.choice(
            "slip", b.slip, slip_words,
            {.unit = "", .text = "`no_slip`: fluid sticks to the body; `free_slip`: it slides"});
        moved_keys(v, b);
        free_keys(v, b);
        v.tables("key", "A key frame of a `moved` body: `[[body.key]]`, below its `[[body]]`.",
                 b.key, [&](Scene::Body::Key& k) { key_frame_keys(v, k); });
      });
  v.tables("joint", "A hinge of a `free` body: `[joint]` for one, `[[joint]]` for several.",
           s.joint, [&](Scene::Joint& j) { joint_keys(v, j); });
}

}  // namespace freshet
