// SPDX-License-Identifier: MIT
#include "scene/keys/keys_inlets.h"

#include "scene/keys/keys_output.h"

namespace freshet {
namespace {

void opening_keys(KeyVisitor& v, Scene::Opening& o, std::string_view fallback,
                  const KeyDoc& direction) {
  v.text("name", o.name,
         {.unit = "", .text = "name of its flow in tables and reports", .fallback = fallback});
  v.vector("center", o.center, {.unit = "m", .text = "centre of the opening", .required = true});
  v.vector("direction", o.direction, direction);
  v.number("width", o.width,
           {.unit = "m",
            .text = "width of a slit (2D) or rectangle (3D)",
            .min = 0,
            .above = true,
            .fallback = "none"});
  v.number("height", o.height,
           {.unit = "m",
            .text = "height of a rectangle (3D)",
            .min = 0,
            .above = true,
            .fallback = "none"});
  v.number(
      "radius", o.radius,
      {.unit = "m", .text = "radius of a disc (3D)", .min = 0, .above = true, .fallback = "none"});
  v.vector(
      "up", o.up,
      {.unit = "",
       .text =
           "direction of a rectangle's height; only its part perpendicular to `direction` counts",
       .fallback = "y; z if `direction` is along y"});
}

}  // namespace

void inlet_keys(KeyVisitor& v, Scene::Inlet& in) {
  opening_keys(
      v, in, "inlet[k]",
      {.unit = "", .text = "direction of the flow; its length is ignored", .required = true});
  v.number("speed", in.speed,
           {.unit = "m/s",
            .text = "speed of the liquid in the opening; set it or `flow_rate`",
            .min = 0,
            .above = true,
            .fallback = "none"});
  v.number("flow_rate", in.flow_rate,
           {.unit = flow_rate_unit,
            .text = "inflow, from which the speed follows by the area that the "
                    "opening's particles represent; set it or `speed`",
            .min = 0,
            .above = true,
            .fallback = "none"});
  v.number("start", in.start, {.unit = "s", .text = "start of the flow", .min = 0});
  v.number("stop", in.stop,
           {.unit = "s", .text = "end of the flow", .min = 0, .above = true, .fallback = "never"});
  v.text("recycle", in.recycle,
         {.unit = "", .text = "name of the outlet that supplies this inlet", .fallback = "none"});
  v.number("rest_density", in.rest_density,
           {.unit = density_unit,
            .text = "density at zero pressure (ρ0)",
            .min = 0,
            .above = true,
            .fallback = "that of the first fluid"});
  v.number("viscosity", in.viscosity,
           {.unit = "Pa s",
            .text = "dynamic viscosity (μ), as `fluid.viscosity`",
            .min = 0,
            .fallback = "that of the first fluid"});
  v.text("color", in.color,
         {.unit = "", .text = "colour, as `fluid.color`", .fallback = "that of the first fluid"});
}

void outlet_keys(KeyVisitor& v, Scene::Outlet& out) {
  v.text("name", out.name,
         {.unit = "", .text = "name of its flow in tables and reports", .fallback = "outlet[k]"});
}

void counter_keys(KeyVisitor& v, Scene::Counter& c) {
  opening_keys(
      v, c, "counter[k]",
      {.unit = "",
       .text =
           "direction that counts as positive, backflow being subtracted; its length is ignored",
       .required = true});
}

}  // namespace freshet
