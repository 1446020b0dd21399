// SPDX-License-Identifier: MIT
#include "scene/keys/keys_inlets.h"

#include "scene/keys/keys_output.h"

namespace freshet {
namespace {

void opening_keys(KeyVisitor& v, Scene::Opening& o, std::string_view fallback,
                  const KeyDoc& direction) {
  v.text("name", o.name,
         {.unit = "", .text = "what its flow is reported under", .fallback = fallback});
  v.vector("center", o.center, {.unit = "m", .text = "its middle", .required = true});
  v.vector("direction", o.direction, direction);
  v.number("width", o.width,
           {.unit = "m",
            .text = "of a slit (2D) or a rectangle (3D)",
            .min = 0,
            .above = true,
            .fallback = "none"});
  v.number(
      "height", o.height,
      {.unit = "m", .text = "of a rectangle (3D)", .min = 0, .above = true, .fallback = "none"});
  v.number("radius", o.radius,
           {.unit = "m", .text = "of a disc (3D)", .min = 0, .above = true, .fallback = "none"});
  v.vector("up", o.up,
           {.unit = "",
            .text = "which way a rectangle's height goes, as far as that is across its direction",
            .fallback = "y, or z where the direction is along y"});
}

}  // namespace

void inlet_keys(KeyVisitor& v, Scene::Inlet& in) {
  opening_keys(v, in, "inlet[k]",
               {.unit = "",
                .text = "which way the liquid flows; its length does not matter",
                .required = true});
  v.number("speed", in.speed,
           {.unit = "m/s",
            .text = "of the liquid in the opening; this or flow_rate",
            .min = 0,
            .above = true,
            .fallback = "none"});
  v.number("flow_rate", in.flow_rate,
           {.unit = "m³/s",
            .text = "volume that comes in (m²/s in 2D); the speed follows from the area that the "
                    "opening's particles stand for; this or speed",
            .min = 0,
            .above = true,
            .fallback = "none"});
  v.number("start", in.start, {.unit = "s", .text = "when the flow begins", .min = 0});
  v.number("stop", in.stop,
           {.unit = "s", .text = "when it ends", .min = 0, .above = true, .fallback = "never"});
  v.text("recycle", in.recycle,
         {.unit = "",
          .text = "name of an outlet: what leaves there comes in again here, in whole layers, as "
                  "soon as the one before has made room; the inlet has no other supply",
          .fallback = "none"});
  v.number(
      "rest_density", in.rest_density,
      {.unit = density_unit, .text = "density at zero pressure (ρ0)", .min = 0, .above = true});
  v.number("viscosity", in.viscosity,
           {.unit = "Pa s",
            .text = "dynamic viscosity (μ); `mueller2003` and the pressure solvers",
            .min = 0});
  v.text("color", in.color,
         {.unit = "", .text = "as fluid.color", .fallback = "that of the liquid's place"});
}

void outlet_keys(KeyVisitor& v, Scene::Outlet& out) {
  v.text("name", out.name,
         {.unit = "", .text = "what its flow is reported under", .fallback = "outlet[k]"});
}

void counter_keys(KeyVisitor& v, Scene::Counter& c) {
  opening_keys(v, c, "counter[k]",
               {.unit = "",
                .text = "what flows this way counts, what flows back is taken off; its length "
                        "does not matter",
                .required = true});
}

}  // namespace freshet
