// SPDX-License-Identifier: MIT
#include "scene/keys.h"

namespace freshet {
namespace {

constexpr const char* density_unit = "kg/m² in 2D, kg/m³ in 3D";

/// Where a fluid or a wall stands.
void region_keys(KeyVisitor& v, Scene::Region& r, Words shapes, const KeyDoc& shape,
                 const KeyDoc& side) {
  v.choice("shape", r.shape, shapes, shape);
  v.choice("side", r.side, side_words, side);
  v.vector("min", r.min, {.unit = "m", .text = "lower corner of a box", .fallback = "none"});
  v.vector("max", r.max, {.unit = "m", .text = "upper corner of a box", .fallback = "none"});
  v.vector("center", r.center,
           {.unit = "m", .text = "of a sphere or a cylinder", .fallback = "none"});
  v.number("radius", r.radius,
           {.unit = "m",
            .text = "of a sphere or a cylinder",
            .min = 0,
            .above = true,
            .fallback = "none"});
  v.vector("axis", r.axis,
           {.unit = "",
            .text = "direction of a cylinder; its length does not matter",
            .fallback = "along y"});
  v.number("length", r.length,
           {.unit = "m", .text = "of a cylinder", .min = 0, .above = true, .fallback = "none"});
  v.vector("point", r.point, {.unit = "m", .text = "any point of a plane", .fallback = "none"});
  v.vector("normal", r.normal,
           {.unit = "",
            .text = "of a plane; `inside` is where it does not point; its length does not matter",
            .fallback = "none"});
  v.text("file", r.file,
         {.unit = "",
          .text = "the points: `*.ply` (vertices with x, y, z and perhaps vx, vy, vz), `*.vtp` "
                  "(points and perhaps an array `velocity`) or `*.csv` (a first line that names "
                  "the columns x, y, z, vx, vy, vz); relative to the scene",
          .fallback = "none"});
}

void fluid_keys(KeyVisitor& v, Scene::Fluid& f) {
  region_keys(v, f, shape_words,
              {.unit = "",
               .text = "`box`: particles fill min to max, the first half a spacing inside; "
                       "`lattice`: `count` particles, the first at `from`; `sphere` (in 2D a "
                       "disc), `cylinder` (3D), `plane` (all of the domain below it): the places "
                       "of such a lattice that lie inside; `points`: those of a file"},
              {.unit = "",
               .text = "`inside` of the shape, or the domain `outside` of it; what walls take up "
                       "is left out either way"});
  v.vector("from", f.from,
           {.unit = "m", .text = "first particle of a lattice", .fallback = "none"});
  v.counts("count", f.count,
           {.unit = "",
            .text = "particles of a lattice along x, y and z",
            .min = 1,
            .fallback = "none"});
  v.vector("velocity", f.velocity,
           {.unit = "m/s", .text = "velocity at the start", .fallback = "at rest"});
  v.number(
      "rest_density", f.rest_density,
      {.unit = density_unit, .text = "density at zero pressure (ρ0)", .min = 0, .above = true});
  v.number("viscosity", f.viscosity,
           {.unit = "Pa s", .text = "dynamic viscosity (μ); `mueller2003` only", .min = 0});
  v.choice("pressure", f.pressure, pressure_words,
           {.unit = "",
            .text = "at the start: `zero`, every particle at rest density; `hydrostatic`, as the "
                    "weight of the fluid above asks for (box, lattice and plane)"});
  v.choice("outside", f.outside, outside_words,
           {.unit = "",
            .text = "a particle that starts outside the domain is an error, or is left to the "
                    "walls (`clamp`: the first step puts it onto the wall)"});
}

void wall_surface_keys(KeyVisitor& v, Slip& slip, double& restitution) {
  v.choice("slip", slip, slip_words,
           {.unit = "",
            .text = "`no_slip`: fluid sticks to the wall; `free_slip`: it glides (`ghost`, "
                    "`akinci2012` and `adami2012`)"});
  v.number("restitution", restitution,
           {.unit = "",
            .text = "share of the normal speed that a particle keeps when a wall turns it back "
                    "(`reflection`)",
            .min = 0,
            .max = 1});
}

void wall_keys(KeyVisitor& v, Scene::Wall& w) {
  v.text("name", w.name,
         {.unit = "", .text = "what its forces are reported under", .fallback = "wall[k]"});
  region_keys(
      v, w, Words(shape_words).first(5),
      {.unit = "",
       .text = "`box`, `sphere` (in 2D a disc), `cylinder` (3D), `plane`, or the `points` "
               "of a file"},
      {.unit = "", .text = "where the fluid is: `outside` of an obstacle, `inside` of a tank"});
  v.choice("method", w.method, method_words,
           {.unit = "",
            .text = "how it holds the fluid: see [walls]; `ghost` for a plane and the inside of a "
                    "box, `monaghan2009`, `akinci2012` or `adami2012` for points",
            .fallback = "`reflection` for `mueller2003`, else `akinci2012`"});
  wall_surface_keys(v, w.slip, w.restitution);
}

void walls_keys(KeyVisitor& v, Scene::Walls& w) {
  v.choice("method", w.method, method_words,
           {.unit = "",
            .text = "of the sides that are not given: `open` (nothing holds the fluid), "
                    "`reflection` (particles are turned back), `ghost` (mirror images), or "
                    "samples as in the papers Monaghan & Kajtar 2009, Akinci et al. 2012, Adami "
                    "et al. 2012",
            .fallback = "`reflection` for `mueller2003`, else `akinci2012`"});
  const auto side = [&](const char* name, std::optional<WallMethod>& method, const char* text) {
    v.choice(name, method, method_words, {.unit = "", .text = text, .fallback = "walls.method"});
  };
  side("x_min", w.x_min, "method of the side where x is least");
  side("x_max", w.x_max, "where x is greatest");
  side("y_min", w.y_min, "of the bottom");
  side("y_max", w.y_max, "of the top");
  side("z_min", w.z_min, "where z is least (3D)");
  side("z_max", w.z_max, "where z is greatest (3D)");
  wall_surface_keys(v, w.slip, w.restitution);
}

void solver_keys(KeyVisitor& v, Scene::Solver& s) {
  v.choice("name", s.name, solver_words, {.unit = "", .text = "the method, named after its paper"});
  v.choice("scheme", s.scheme, scheme_words,
           {.unit = "",
            .text = "`paper`: the equations as published; `article`: as the teaching article runs "
                    "them (see docs/article.md for the five differences)"});
  v.choice(
      "backend", s.backend, backend_words,
      {.unit = "",
       .text =
           "what computes: `cpu` has threads and SIMD; `reference` is scalar, the truth that `cpu` "
           "equals to the bit"});
  v.choice("search", s.search, search_words,
           {.unit = "", .text = "how neighbours are found: O(N) or O(N²), to the same bits"});
  v.choice("neighbor_order", s.neighbor_order, order_words,
           {.unit = "",
            .text = "order of a particle's sum: by cell, then id; or by id, as a loop over all "
                    "particles has it"});
  v.number("stiffness", s.stiffness,
           {.unit = "m²/s²",
            .text = "k in p = k(ρ − ρ0), the square of the speed of sound; `mueller2003` only",
            .min = 0,
            .above = true,
            .fallback = "(10 · √(2 g · height of the domain))²"});
  v.choice("kernel", s.kernel, kernel_words,
           {.unit = "", .text = "smoothing kernel of `wcsph` and `delta_sph`"});
  v.number("sound_speed", s.sound_speed,
           {.unit = "m/s",
            .text = "c in Tait's equation of state; `wcsph` and `delta_sph`",
            .min = 0,
            .above = true,
            .fallback = "10 · √(2 g · height of the domain)"});
  v.number("artificial_viscosity", s.artificial_viscosity,
           {.unit = "", .text = "α of Monaghan's term; `wcsph` and `delta_sph`", .min = 0});
  v.choice("density_diffusion", s.density_diffusion, diffusion_words,
           {.unit = "", .text = "the term of `delta_sph`, named after its paper"});
  v.number("delta", s.delta, {.unit = "", .text = "δ, its strength; `delta_sph` only", .min = 0});
  v.number("speed_limit", s.speed_limit,
           {.unit = "m/s",
            .text = "faster particles are slowed to it (scheme `article` only)",
            .min = 0,
            .above = true,
            .fallback = "none"});
}

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
    v.choice(
        "color_by", p.color_by, color_by_words,
        {.unit = "", .text = "what the colours tell; `density_error` is ρ/ρ0 − 1, `height` is y"});
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

}  // namespace

void visit_keys(KeyVisitor& v, Scene& s) {
  v.text("title", s.title, {.unit = "", .text = "a line for the list of scenes"});
  v.text("description", s.description, {.unit = "", .text = "what the scene shows"});
  v.section("domain", "The box that the fluid lives in.", [&] {
    v.vector("min", s.domain.min, {.unit = "m", .text = "lower corner", .fallback = "the origin"});
    v.vector("max", s.domain.max,
             {.unit = "m",
              .text = "upper corner; 2 numbers make a scene in 2D, 3 in 3D",
              .required = true});
    v.vector("gravity", s.domain.gravity,
             {.unit = "m/s²", .text = "acceleration of gravity", .fallback = "9.81 along −y"});
    v.choice("periodic", s.domain.periodic, axes_words,
             {.unit = "", .text = "axes along which the domain repeats itself"});
  });
  v.section("particles", "How the fluid is cut into particles.", [&] {
    v.number("spacing", s.particles.spacing,
             {.unit = "m",
              .text = "distance of neighbours at the start",
              .min = 0,
              .above = true,
              .required = true});
    v.number("support_radius", s.particles.support_radius,
             {.unit = "m",
              .text = "where the kernels end (the paper's h)",
              .min = 0,
              .above = true,
              .fallback = "2 × spacing"});
    v.number("mass", s.particles.mass,
             {.unit = "kg",
              .text = "mass of a particle (scheme `article` only)",
              .min = 0,
              .above = true,
              .fallback = "rest_density × spacing² in 2D, spacing³ in 3D"});
    v.number("jitter", s.particles.jitter,
             {.unit = "m",
              .text = "each coordinate moves by a uniform random number up to this, either way",
              .min = 0});
    v.integer("seed", s.particles.seed,
              {.unit = "", .text = "seed of the jitter", .min = 0, .max = 4294967295.0});
  });
  v.tables("fluid", "A body of fluid: `[fluid]` for one, `[[fluid]]` for several.", s.fluid,
           [&](Scene::Fluid& f) { fluid_keys(v, f); });
  v.tables("wall", "An obstacle or a tank: `[wall]` for one, `[[wall]]` for several.", s.wall,
           [&](Scene::Wall& w) { wall_keys(v, w); });
  v.section("solver", "The method and what computes it.", [&] { solver_keys(v, s.solver); });
  v.section("walls", "The sides of the domain.", [&] { walls_keys(v, s.walls); });
  v.section("time", "How long, and in what steps.", [&] {
    v.number("end", s.time.end,
             {.unit = "s", .text = "simulated time", .min = 0, .above = true, .required = true});
    v.number_or_word("step", s.time.step, s.time.adaptive, "adaptive",
                     {.unit = "s",
                      .text = "time step; the run takes round(end/step) steps. `\"adaptive\"`: as "
                              "long as is stable, at most step_max",
                      .min = 0,
                      .above = true,
                      .required = true});
    v.number("step_max", s.time.step_max,
             {.unit = "s",
              .text = "longest adaptive step",
              .min = 0,
              .above = true,
              .fallback = "none; an adaptive step needs it"});
    v.choice("integrator", s.time.integrator, integrator_words,
             {.unit = "",
              .text = "how a step moves the particles",
              .fallback = "`symplectic_euler` for `wcsph`, else `leapfrog`"});
  });
  output_keys(v, s);
}

}  // namespace freshet
