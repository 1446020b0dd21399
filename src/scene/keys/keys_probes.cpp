// SPDX-License-Identifier: MIT
#include "scene/keys/keys_probes.h"

namespace freshet {

void probe_keys(KeyVisitor& v, Scene::Probe& p) {
  v.text("name", p.name, {.unit = "", .text = "name of its table", .fallback = "probe_k"});
  v.choice("kind", p.kind, probe_words, {.unit = "", .text = "what the probe measures"});
  v.vector("at", p.at, {.unit = "m", .text = "position of a `point`", .fallback = "none"});
  v.vector("from", p.from,
           {.unit = "m", .text = "start of a line; corner of a rectangle", .fallback = "none"});
  v.vector(
      "to", p.to,
      {.unit = "m", .text = "end of a line; opposite corner of a rectangle", .fallback = "none"});
  v.vector("along", p.along,
           {.unit = "",
            .text = "direction of one edge of an inclined `wall` rectangle in 3D; any length",
            .fallback = "the edges are parallel to the axes"});
  v.integer("count", p.count,
            {.unit = "",
             .text = "number of points of a `line`, including both ends",
             .min = 2,
             .max = 1e6});
  v.number("apart", p.apart,
           {.unit = "m",
            .text = "approximate distance between the points of a `plane`, which include its edges",
            .min = 0,
            .above = true,
            .fallback = "particles.spacing"});
  v.text("body", p.body,
         {.unit = "",
          .text = "name of the body that carries the probe, as a gauge on a moving wall; positions "
                  "are those at the start",
          .fallback = "none; it is fixed"});
  v.number("every", p.every,
           {.unit = "s",
            .text = "interval of measurements: after the first step at or after each such time",
            .min = 0,
            .above = true,
            .fallback = "as the observables"});
}

}  // namespace freshet
