// SPDX-License-Identifier: MIT
#include "scene/keys/keys_output.h"

namespace freshet {
namespace {

void data_keys(KeyVisitor& v, Scene::Output& o) {
  v.choices("data", o.data, data_words,
            {.unit = "",
             .text = "formats of data files: `vtp` (ParaView, with a `*.pvd` of all times), `ply` "
                     "(Blender, Houdini), `csv`, `hdf5`, `bgeo` (Houdini); `[]` for none"});
  v.choices("fields", o.fields, field_words,
            {.unit = "", .text = "fields of data files, besides the position"});
  v.choice("precision", o.precision, precision_words,
           {.unit = "",
            .text = "precision of data files; `float16` (`hdf5` only) halves the size of velocity, "
                    "density and pressure, unless a value is beyond 65504"});
  v.integer("data_every_steps", o.data_every_steps,
            {.unit = "steps",
             .text = "interval of data files; there is one after step 0 and after the last step",
             .min = 1,
             .max = 1e9,
             .fallback = "as the frames"});
  v.number("data_every", o.data_every,
           {.unit = "s",
            .text = "interval of data files instead, in simulated seconds",
            .min = 0,
            .above = true,
            .fallback = "as the frames"});
}

/// The settings of surfaces as keys.
struct SettingKeys {
  KeyVisitor& v;
  void number(const char* name, double& value, double low, double high, const char* text) {
    v.number(name, value, {.unit = "", .text = text, .min = low, .max = high});
  }
  void count(const char* name, int& value, int low, int high, const char* text) {
    std::int64_t whole = value;
    v.integer(name, whole, {.unit = "", .text = text, .min = double(low), .max = double(high)});
    value = int(whole);
  }
  template <class E> void choice(const char* name, E& value, Words words, const char* text) {
    v.choice(name, value, words, {.unit = "", .text = text});
  }
  void flag(const char* name, bool& value, const char* text) {
    v.boolean(name, value, {.unit = "", .text = text});
  }
};

void surface_keys(KeyVisitor& v, Scene& s) {
  v.optional_table(
      "surface",
      R"(Closed meshes of the fluid in 3D, surface/surface_0000.ply and so on, which the run writes while
it runs. Without this table there are none; `freshet surface` makes the same from data files. `cell`
must be at most half of `radius`. docs/surface.md describes the settings.)",
      s.surface, [&](Scene::Surface& surface) {
        SettingKeys keys{v};
        visit_files(keys, surface);
        v.integer("every_steps", surface.every_steps,
                  {.unit = "steps",
                   .text = "interval of meshes; there is one after step 0 and after the last step",
                   .min = 1,
                   .max = 1e9,
                   .fallback = "as the data files"});
        v.number("every", surface.every,
                 {.unit = "s",
                  .text = "interval of meshes instead, in simulated seconds",
                  .min = 0,
                  .above = true,
                  .fallback = "as the data files"});
      });
}

void camera_keys(KeyVisitor& v, Scene::Camera& c) {
  v.number("time", c.time, {.unit = "s", .text = "time of a key frame", .min = 0});
  v.vector("position", c.position,
           {.unit = "m",
            .text = "position of the eye",
            .fallback = "in front, to the right and above, with the whole domain in view"});
  v.vector("target", c.target,
           {.unit = "m",
            .text = "point at the centre of the picture",
            .fallback = "centre of the domain"});
  v.number("field_of_view", c.field_of_view,
           {.unit = "degrees", .text = "vertical angle of view", .min = 1, .max = 150});
  v.number("orbit", c.orbit,
           {.unit = "degrees/s",
            .text = "angular speed about the vertical through the target, to the right if > 0",
            .min = -36000,
            .max = 36000});
}

void picture_keys(KeyVisitor& v, Scene& s) {
  auto& p = s.picture;
  v.section("picture", "How a frame is drawn.", [&] {
    v.integer("width", p.width,
              {.unit = "px",
               .text = "width",
               .min = 32,
               .max = 8192,
               .fallback = "follows the height and the domain; the longer side of the domain is "
                           "800 if neither is set"});
    v.integer("height", p.height,
              {.unit = "px",
               .text = "height",
               .min = 32,
               .max = 8192,
               .fallback = "follows the width and the domain"});
    v.boolean(
        "stretch", p.stretch,
        {.unit = "",
         .text = "in 2D: the domain fills `width` and `height`, each axis with a scale of its "
                 "own; otherwise it is centred with equal scales"});
    v.choice("dots", p.dots, dots_words,
             {.unit = "",
              .text = "in 2D: `solid`, discs in the exact colours; `glow`, soft dots whose light "
                      "adds up, as in the article"});
    v.integer("dot_radius", p.dot_radius,
              {.unit = "px",
               .text = "radius of a particle's dot (2D)",
               .min = 1,
               .max = 200,
               .fallback = "slightly more than half a spacing; 5 if `glow`"});
    v.choice(
        "style", p.style, style_words,
        {.unit = "",
         .text = "in 3D: `balls`, a lit ball per particle in the colours of `color_by`; "
                 "`water`, the surfaces of the liquids, clear and in their colours: they "
                 "reflect a sky, refract what is behind them and absorb light by their depth"});
    v.numbers("window", p.window, 4,
              {.unit = "m",
               .text = "visible region in 2D: x_min, y_min, x_max, y_max",
               .fallback = "the domain"});
    v.choice("color_by", p.color_by, color_by_words,
             {.unit = "",
              .text = "quantity that the colours show; `density_error` is ρ/ρ0 − 1, `height` is y, "
                      "`liquid` gives each liquid a colour"});
    v.choice("color_map", p.color_map, color_map_words,
             {.unit = "",
              .text = "colours from the minimum to the maximum",
              .fallback = "`water` for `speed`, `coolwarm` for signed quantities, else `viridis`"});
    v.numbers("color_range", p.color_range, 2,
              {.unit = "as color_by",
               .text = "minimum and maximum; values beyond have the colours of the ends",
               .fallback = "by `color_scale`"});
    v.choice(
        "color_scale", p.color_scale, color_scale_words,
        {.unit = "",
         .text = "range without `color_range`: `run`, what 98 % of the particles have had up "
                 "to the picture (percentiles.csv); `picture`, the minimum and maximum of each "
                 "picture, as in the article"});
    v.text("background", p.background,
           {.unit = "", .text = "`night`, `black`, `grey`, `white` or `#rrggbb`"});
    v.boolean("time_stamp", p.time_stamp, {.unit = "", .text = "shows the time in a corner"});
    v.boolean("scale_bar", p.scale_bar, {.unit = "", .text = "shows a bar and its length (2D)"});
    v.boolean("color_bar", p.color_bar,
              {.unit = "", .text = "shows the colours and their values, right of the domain"});
  });
  v.tables("camera",
           "The camera of pictures in 3D: `[camera]` for one that stands still or orbits, "
           "`[[camera]]` for key frames between which it moves smoothly.",
           s.camera, [&](Scene::Camera& c) { camera_keys(v, c); });
}

}  // namespace

void output_keys(KeyVisitor& v, Scene& s) {
  v.section("output", "What a run writes, and how often.", [&] {
    v.integer("frame_every_steps", s.output.frame_every_steps,
              {.unit = "steps",
               .text = "interval of frames; there is one after step 0 and after the last step",
               .min = 1,
               .max = 1e9,
               .fallback = "a tenth of the run"});
    v.number("frame_every", s.output.frame_every,
             {.unit = "s",
              .text = "interval of frames instead, in simulated seconds: frames show exactly these "
                      "times, 0 and the end too, interpolated between two steps",
              .min = 0,
              .above = true,
              .fallback = "a tenth of the run"});
    v.integer("observables_every_steps", s.output.observables_every_steps,
              {.unit = "steps",
               .text = "interval of the lines of observables.csv; there is one after step 0 and "
                       "after the last step",
               .min = 1,
               .max = 1e9,
               .fallback = "a hundredth of the run"});
    v.number("observables_every", s.output.observables_every,
             {.unit = "s",
              .text = "interval of these lines instead, in simulated seconds",
              .min = 0,
              .above = true,
              .fallback = "a hundredth of the run"});
    v.boolean(
        "statistics", s.output.statistics,
        {.unit = "",
         .text = "adds columns to the tables of observables and probes: minimum, maximum, "
                 "mean and integral (of a force: the impulse) over all steps since the last "
                 "row, of forces on walls and bodies and of probes. Measures after every step"});
    data_keys(v, s.output);
    v.integer("checkpoint_every_steps", s.output.checkpoint_every_steps,
              {.unit = "steps",
               .text = "interval of checkpoints for `freshet resume`; the last two are kept; there "
                       "is always one at the end and on Ctrl-C",
               .min = 1,
               .max = 1e9,
               .fallback = "every five minutes of run time"});
    v.number("checkpoint_every", s.output.checkpoint_every,
             {.unit = "s",
              .text = "interval of checkpoints instead, in simulated seconds",
              .min = 0,
              .above = true,
              .fallback = "every five minutes of run time"});
  });
  surface_keys(v, s);
  picture_keys(v, s);
  v.section("checks", "Conditions at the end of a run. A run whose check fails exits with 1.", [&] {
    v.integer(
        "out_of_bounds_max", s.checks.out_of_bounds_max,
        {.unit = "",
         .text = "maximum number of particles further than a support radius outside the domain",
         .min = 0,
         .fallback = "unchecked"});
    v.number(
        "density_mean_min", s.checks.density_mean_min,
        {.unit = density_unit, .text = "lower bound of the mean density", .fallback = "unchecked"});
    v.number("speed_mean_max", s.checks.speed_mean_max,
             {.unit = "m/s", .text = "upper bound of the mean speed", .fallback = "unchecked"});
    v.number("height_mean_max", s.checks.height_mean_max,
             {.unit = "m", .text = "upper bound of the mean height (y)", .fallback = "unchecked"});
    v.number(
        "bright_fraction_min", s.checks.bright_fraction_min,
        {.unit = "",
         .text = "lower bound of the fraction of bright pixels (R > 50 or G > 30) in the result",
         .min = 0,
         .max = 1,
         .fallback = "unchecked"});
    v.choice("when_wrong", s.checks.when_wrong, wrong_words,
             {.unit = "",
              .text = "when a run becomes unphysical (docs/when_it_goes_wrong.md): `stop`, or "
                      "`warn` and continue while the numbers are finite; both exit with 1"});
  });
}

}  // namespace freshet
