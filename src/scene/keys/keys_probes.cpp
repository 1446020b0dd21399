// SPDX-License-Identifier: MIT
#include "scene/keys/keys_probes.h"

namespace freshet {

void probe_keys(KeyVisitor& v, Scene::Probe& p) {
  v.text("name", p.name, {.unit = "", .text = "of its table", .fallback = "probe_k"});
  v.choice("kind", p.kind, probe_words,
           {.unit = "",
            .text = "`point`: the share of fluid, velocity, density and pressure `at` a place; "
                    "`line`: at `count` places; `plane`: at places of a rectangle along the axes; "
                    "`surface`: how far along a line the fluid reaches, which upwards is the "
                    "water's height and along the floor its front; `wall`: the traction, the force "
                    "of the fluid over the area, of a rectangle of a wall along the axes, in 2D of "
                    "a stretch of it, whose part across is the pressure on the wall"});
  v.vector("at", p.at, {.unit = "m", .text = "place of a point", .fallback = "none"});
  v.vector(
      "from", p.from,
      {.unit = "m", .text = "where a line begins; a corner of a rectangle", .fallback = "none"});
  v.vector("to", p.to,
           {.unit = "m", .text = "where it ends; the opposite corner", .fallback = "none"});
  v.integer("count", p.count,
            {.unit = "", .text = "places of a line, its ends included", .min = 2, .max = 1e6});
  v.number("apart", p.apart,
           {.unit = "m",
            .text = "about how far from each other the places of a plane are, its edges included",
            .min = 0,
            .above = true,
            .fallback = "particles.spacing"});
  v.text("body", p.body,
         {.unit = "",
          .text = "the body that carries the probe, which is told where it stands at the start: a "
                  "gauge on a moving wall",
          .fallback = "none: it stays"});
  v.number("every", p.every,
           {.unit = "s",
            .text = "how often: after the first step at or after each such time",
            .min = 0,
            .above = true,
            .fallback = "as the observables"});
}

}  // namespace freshet
