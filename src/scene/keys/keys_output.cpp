// SPDX-License-Identifier: MIT
#include "scene/keys/keys_output.h"

namespace freshet {
namespace {

void data_keys(KeyVisitor& v, Scene::Output& o) {
  v.choices(
      "data", o.data, data_words,
      {.unit = "",
       .text = "files of the particles beside the pictures: `vtp` (with a `*.pvd` of all "
               "times, for ParaView), `ply` (Blender, Houdini), `csv`, `hdf5`; `[]` for none"});
  v.choices("fields", o.fields, field_words,
            {.unit = "", .text = "what these files hold besides the position"});
  v.choice("precision", o.precision, precision_words,
           {.unit = "",
            .text = "of the numbers in data files; `float16` (`hdf5` only) halves velocity, "
                    "density and pressure, unless they are beyond 65504"});
  v.integer("data_every_steps", o.data_every_steps,
            {.unit = "steps",
             .text = "data files after step 0, after every so many steps, and after the last",
             .min = 1,
             .max = 1e9,
             .fallback = "as the frames"});
  v.number("data_every", o.data_every,
           {.unit = "s",
            .text = "the same in seconds",
            .min = 0,
            .above = true,
            .fallback = "as the frames"});
}

void camera_keys(KeyVisitor& v, Scene::Camera& c) {
  v.number("time", c.time, {.unit = "s", .text = "of a key frame", .min = 0});
  v.vector("position", c.position,
           {.unit = "m",
            .text = "where the eye is",
            .fallback = "in front, to the right and above, so that all of the domain is seen"});
  v.vector("target", c.target,
           {.unit = "m", .text = "what it looks at", .fallback = "the middle of the domain"});
  v.number("field_of_view", c.field_of_view,
           {.unit = "degrees",
            .text = "angle from the bottom of the picture to its top",
            .min = 1,
            .max = 150});
  v.number("orbit", c.orbit,
           {.unit = "degrees/s",
            .text = "how fast it turns about the vertical through the target, to the right if > 0",
            .min = -36000,
            .max = 36000});
}

void picture_keys(KeyVisitor& v, Scene& s) {
  auto& p = s.picture;
  v.section("picture", "How a frame is drawn.", [&] {
    v.integer("width", p.width, {.unit = "px", .text = "width", .min = 32, .max = 8192});
    v.integer("height", p.height, {.unit = "px", .text = "height", .min = 32, .max = 8192});
    v.choice("dots", p.dots, dots_words,
             {.unit = "",
              .text = "in 2D: `glow`, soft dots whose light adds up, as in the article; `solid`, "
                      "discs that show the colours as they are"});
    v.integer("dot_radius", p.dot_radius,
              {.unit = "px",
               .text = "radius of a particle's dot (2D)",
               .min = 1,
               .max = 200,
               .fallback = "5; a little over half a spacing if `solid`"});
    v.numbers("window", p.window, 4,
              {.unit = "m",
               .text = "what is seen in 2D: x_min, y_min, x_max, y_max",
               .fallback = "the domain"});
    v.choice("color_by", p.color_by, color_by_words,
             {.unit = "",
              .text = "what the colours tell; `density_error` is ρ/ρ0 − 1, `height` is y, `liquid` "
                      "has a colour each"});
    v.choice("color_map", p.color_map, color_map_words,
             {.unit = "",
              .text = "the colours from the least value to the greatest",
              .fallback = "`article` in 2D, `water` in 3D"});
    v.numbers("color_range", p.color_range, 2,
              {.unit = "as color_by",
               .text = "the least value and the greatest; beyond, the colours of the ends",
               .fallback = "of each picture's particles; `speed` from 0 to at least 0.1 m/s"});
    v.text("background", p.background,
           {.unit = "", .text = "`night`, `black`, `grey`, `white` or `#rrggbb`"});
    v.boolean("time_stamp", p.time_stamp, {.unit = "", .text = "the time in a corner"});
    v.boolean("scale_bar", p.scale_bar, {.unit = "", .text = "a bar and its length (2D)"});
    v.boolean("color_bar", p.color_bar, {.unit = "", .text = "the colours and their values"});
  });
  v.tables("camera",
           "Where a picture in 3D is seen from. `[camera]` for one that stands or orbits; "
           "`[[camera]]` for several, key frames between which it moves smoothly.",
           s.camera, [&](Scene::Camera& c) { camera_keys(v, c); });
}

}  // namespace

void output_keys(KeyVisitor& v, Scene& s) {
  v.section("output", "What a run writes, and how often.", [&] {
    v.integer("frame_every_steps", s.output.frame_every_steps,
              {.unit = "steps",
               .text = "a frame after step 0, after every so many steps, and after the last",
               .min = 1,
               .max = 1e9,
               .fallback = "a tenth of the run"});
    v.number("frame_every", s.output.frame_every,
             {.unit = "s",
              .text = "instead of steps: a frame after the first step at or after each such time",
              .min = 0,
              .above = true,
              .fallback = "a tenth of the run"});
    v.integer("observables_every_steps", s.output.observables_every_steps,
              {.unit = "steps",
               .text = "a line of observables.csv after step 0, every so many steps, and the last",
               .min = 1,
               .max = 1e9,
               .fallback = "a hundredth of the run"});
    v.number("observables_every", s.output.observables_every,
             {.unit = "s",
              .text = "the same in seconds",
              .min = 0,
              .above = true,
              .fallback = "a hundredth of the run"});
    data_keys(v, s.output);
    v.integer("checkpoint_every_steps", s.output.checkpoint_every_steps,
              {.unit = "steps",
               .text = "a checkpoint after every so many steps, for `freshet resume`; the last two "
                       "stay; there is one at the end, and on Ctrl-C, in any case",
               .min = 1,
               .max = 1e9,
               .fallback = "every five minutes that the run takes"});
    v.number("checkpoint_every", s.output.checkpoint_every,
             {.unit = "s",
              .text = "the same in simulated seconds",
              .min = 0,
              .above = true,
              .fallback = "every five minutes that the run takes"});
  });
  picture_keys(v, s);
  v.section("checks", "What must hold at the end; a run whose check fails exits with 1.", [&] {
    v.integer("out_of_bounds_max", s.checks.out_of_bounds_max,
              {.unit = "",
               .text = "most particles further than a support radius outside the domain",
               .min = 0,
               .fallback = "unchecked"});
    v.number("density_mean_min", s.checks.density_mean_min,
             {.unit = density_unit, .text = "mean density is above", .fallback = "unchecked"});
    v.number("speed_mean_max", s.checks.speed_mean_max,
             {.unit = "m/s", .text = "mean speed is below", .fallback = "unchecked"});
    v.number("height_mean_max", s.checks.height_mean_max,
             {.unit = "m", .text = "mean height (y) is below", .fallback = "unchecked"});
    v.number("bright_fraction_min", s.checks.bright_fraction_min,
             {.unit = "",
              .text = "share of bright pixels (R > 50 or G > 30) in the result is above",
              .min = 0,
              .max = 1,
              .fallback = "unchecked"});
    v.choice("when_wrong", s.checks.when_wrong, wrong_words,
             {.unit = "",
              .text = "what a run does that cannot be right any more (see "
                      "docs/when_it_goes_wrong.md): `stop`; or `warn` and go on as long as the "
                      "numbers are finite, to exit with 1 all the same"});
  });
}

}  // namespace freshet
