// SPDX-License-Identifier: MIT
#include "scene/keys/keys_whitewater.h"

namespace freshet {
namespace {

void birth_keys(KeyVisitor& v, Scene::Whitewater& w) {
  v.number("trapped_air", w.trapped_air,
           {.unit = "",
            .text = "births at a fluid particle that traps air, per `particles.spacing` of its "
                    "path; 0: none",
            .min = 0,
            .max = 100});
  v.number("wave_crest", w.wave_crest,
           {.unit = "",
            .text = "births at a fluid particle in the crest of a wave, per `particles.spacing` of "
                    "its path; 0: none",
            .min = 0,
            .max = 100});
  v.number("turbulence", w.turbulence,
           {.unit = "",
            .text = "births at a fluid particle where the vorticity varies, per "
                    "`particles.spacing` of its path; 0: none",
            .min = 0,
            .max = 100});
  v.numbers(
      "trapped_air_limits", w.trapped_air_limits, 2,
      {.unit = "m/s",
       .text = "mean approach of the neighbours where trapped air begins, and where it is full",
       .fallback = "0.1 and 0.4 of the maximum speed that `info` prints"});
  v.numbers("wave_crest_limits", w.wave_crest_limits, 2,
            {.unit = "",
             .text = "curvature where a wave crest begins, and where it is full: the mean of 1 − "
                     "cos of the angle between normals",
             .fallback = "0.2 and 0.8"});
  v.numbers("turbulence_limits", w.turbulence_limits, 2,
            {.unit = "m/s",
             .text = "mean difference between the vorticities of neighbours, times the support "
                     "radius, where turbulence begins, and where it is full",
             .fallback = "0.1 and 0.4 of the maximum speed that `info` prints"});
  v.numbers("speed_limits", w.speed_limits, 2,
            {.unit = "m/s",
             .text = "speed below which nothing is born, and from which on all is",
             .fallback = "0.15 and 0.5 of the maximum speed that `info` prints"});
}

}  // namespace

void whitewater_keys(KeyVisitor& visitor, Scene& scene) {
  visitor.optional_table(
      "whitewater",
      R"(Spray, foam and bubbles, after Ihmsen et al. 2012. No key is required.

They are born where water breaks, move with the fluid, and do not act on it: the fluid
has the same bits with and without them. docs/whitewater.md explains the keys. Data
files have them in files of their own, and pictures show them.)",
      scene.whitewater, [&](Scene::Whitewater& w) {
        birth_keys(visitor, w);
        visitor.numbers("lifetime", w.lifetime, 2,
                        {.unit = "s",
                         .text = "how long foam lasts: at the lowest and at the highest speed of "
                                 "`speed_limits`",
                         .fallback = "2 and 5"});
        visitor.number("buoyancy", w.buoyancy,
                       {.unit = "",
                        .text = "acceleration of a bubble at rest, as a multiple of gravity",
                        .min = 0,
                        .max = 1000});
        visitor.number("rise_speed", w.rise_speed,
                       {.unit = "m/s",
                        .text = "speed at which bubbles rise in still water",
                        .min = 0,
                        .above = true});
        visitor.integer("max_particles", w.max_particles,
                        {.unit = "",
                         .text = "maximum number of them; further births are left out, with a "
                                 "warning",
                         .min = 0,
                         .max = 1e9,
                         .fallback = "three times the number of fluid particles"});
        visitor.integer("seed", w.seed,
                        {.unit = "", .text = "seed of the births", .min = 0, .max = 4294967295.0});
      });
}

}  // namespace freshet
