// SPDX-License-Identifier: MIT
#include "scene/keys/keys.h"

#include "scene/keys/keys_bodies.h"
#include "scene/keys/keys_forces.h"
#include "scene/keys/keys_inlets.h"
#include "scene/keys/keys_output.h"
#include "scene/keys/keys_probes.h"

namespace freshet {

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
}

void file_keys(KeyVisitor& v, Scene::Region& r) {
  v.text("file", r.file,
         {.unit = "",
          .text = "the points: `*.ply` (vertices with x, y, z and perhaps vx, vy, vz), `*.vtp` "
                  "(points and perhaps an array `velocity`) or `*.csv` (a first line that names "
                  "the columns x, y, z, vx, vy, vz); the mesh: `*.stl`, `*.obj` or `*.ply`; "
                  "relative to the scene",
          .fallback = "none"});
  v.number("scale", r.scale,
           {.unit = "m",
            .text = "what one unit of a mesh's file is: 0.001 for millimetres",
            .min = 0,
            .above = true});
  v.vector("rotation", r.rotation,
           {.unit = "°",
            .text = "of a mesh about x, then y, then z, after scaling; [-90, 0, 0] stands up what "
                    "has z upwards",
            .fallback = "none"});
  v.vector("translation", r.translation,
           {.unit = "m", .text = "of a mesh, after turning", .fallback = "none"});
}

namespace {

void fluid_keys(KeyVisitor& v, Scene::Fluid& f) {
  region_keys(
      v, f, shape_words,
      {.unit = "",
       .text = "`box`: particles fill min to max, the first half a spacing inside; "
               "`lattice`: `count` particles, the first at `from`; `sphere` (in 2D a "
               "disc), `cylinder` (3D), `plane` (all of the domain below it): the places "
               "of such a lattice that lie inside; `mesh` (3D): so within the triangles of a "
               "file; `points`: those of a file"},
      {.unit = "",
       .text = "`inside` of the shape, or the domain `outside` of it; what walls take up "
               "is left out either way"});
  file_keys(v, f);
  v.vector("from", f.from,
           {.unit = "m", .text = "first particle of a lattice", .fallback = "none"});
  v.counts("count", f.count,
           {.unit = "",
            .text = "particles of a lattice along x, y and z",
            .min = 1,
            .fallback = "none"});
  v.vector("velocity", f.velocity,
           {.unit = "m/s", .text = "velocity at the start", .fallback = "at rest"});
  v.texts("velocity_field", f.velocity_field,
          {.unit = "m/s",
           .text = "velocity at the start instead, a function of x, y, z [m] for each axis: "
                   "`[\"sin(pi*x)\", \"0\"]`",
           .fallback = "none"});
  v.number(
      "rest_density", f.rest_density,
      {.unit = density_unit, .text = "density at zero pressure (ρ0)", .min = 0, .above = true});
  v.number("viscosity", f.viscosity,
           {.unit = "Pa s",
            .text = "dynamic viscosity (μ); not with solver.viscosity_method `artificial`",
            .min = 0});
  v.text("color", f.color,
         {.unit = "",
          .text = "`#rrggbb`, where picture.color_by is `liquid`",
          .fallback = "blue, amber, green and so on"});
  fluid_force_keys(v, f);
  v.choice("pressure", f.pressure, pressure_words,
           {.unit = "",
            .text = "at the start: `zero`, every particle at rest density; `hydrostatic`, as the "
                    "weight of the fluid above asks for (box, lattice and plane); the pressure "
                    "solvers keep the density at rest"});
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
      v, w, Words(shape_words).first(6),
      {.unit = "",
       .text = "`box`, `sphere` (in 2D a disc), `cylinder` (3D), `plane`, the `mesh` of a file "
               "(3D; one with holes is a sheet), or its `points`"},
      {.unit = "", .text = "where the fluid is: `outside` of an obstacle, `inside` of a tank"});
  file_keys(v, w);
  v.choice("method", w.method, method_words,
           {.unit = "",
            .text = "how it holds the fluid: see [walls]; `ghost` for a plane and the inside of a "
                    "box, `monaghan2009`, `akinci2012` or `adami2012` for points",
            .fallback = "`reflection` for `mueller2003`, else `akinci2012`"});
  wall_surface_keys(v, w.slip, w.restitution);
  v.vector("velocity", w.velocity,
           {.unit = "m/s",
            .text = "of its surface, which slides along itself as a belt does (`adami2012`)",
            .fallback = "at rest"});
}

void walls_keys(KeyVisitor& v, Scene::Walls& w) {
  v.choice("method", w.method, method_words,
           {.unit = "",
            .text = "of the sides that are not given: `open` (nothing holds the fluid), "
                    "`reflection` (particles are turned back), `ghost` (mirror images), or "
                    "samples as in the papers Monaghan & Kajtar 2009, Akinci et al. 2012, Adami "
                    "et al. 2012 (not with the pressure solvers; bodies are then made of such "
                    "layers as well)",
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

/// Of the solvers that solve for the pressure.
void pressure_keys(KeyVisitor& v, Scene::Solver& s) {
  v.number(
      "density_tolerance", s.density_tolerance,
      {.unit = "",
       .text = "a step iterates until the mean of max(0, ρ*/ρ0 − 1), and of what pressures hold "
               "further apart than at rest, is no more than this; pressure solvers",
       .min = 1e-6,
       .max = 0.1,
       .fallback = "0.0001 for `dfsph`, else 0.001"});
  v.number(
      "divergence_tolerance", s.divergence_tolerance,
      {.unit = "",
       .text = "the same of what a step would change, the mean of max(0, Δt Dρ/Dt)/ρ0; `dfsph` "
               "only",
       .min = 1e-6,
       .max = 1});
  v.integer("min_iterations", s.min_iterations,
            {.unit = "",
             .text = "of a solve, even if its error is small before; pressure solvers",
             .min = 1,
             .max = 1e6});
  v.integer("max_iterations", s.max_iterations,
            {.unit = "",
             .text = "of a solve, even if its error is not small by then; pressure solvers",
             .min = 1,
             .max = 1e6});
  v.boolean("warm_start", s.warm_start,
            {.unit = "",
             .text = "whether a solve begins with what the last step's came to; `iisph` and "
                     "`dfsph`"});
  v.choice(
      "iteration", s.iteration, iteration_words,
      {.unit = "",
       .text = "how `dfsph` iterates: `jacobi` is the paper's own, `nesterov` goes on along its "
               "steps and needs fewer of them"});
  v.number("xsph", s.xsph,
           {.unit = "",
            .text = "share of the neighbours' mean velocity that a particle takes on in a step; "
                    "pressure solvers",
            .min = 0,
            .max = 1});
}

void solver_keys(KeyVisitor& v, Scene::Solver& s) {
  v.choice("name", s.name, solver_words(),
           {.unit = "",
            .text = "the method, named after its paper; `pcisph`, `iisph`, `dfsph` and `pbf` are "
                    "the pressure solvers: each step iterates until the pressure keeps the "
                    "density at rest"});
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
           {.unit = "", .text = "smoothing kernel; `mueller2003` has its own"});
  v.number("sound_speed", s.sound_speed,
           {.unit = "m/s",
            .text = "c in Tait's equation of state; `wcsph` and `delta_sph`",
            .min = 0,
            .above = true,
            .fallback = "10 · √(2 g · height of the domain)"});
  v.number("artificial_viscosity", s.artificial_viscosity,
           {.unit = "",
            .text = "α of Monaghan's term; `wcsph` and `delta_sph`",
            .min = 0,
            .fallback = "0.05; 0 where solver.viscosity_method is another than `artificial`"});
  v.choice("density_diffusion", s.density_diffusion, diffusion_words,
           {.unit = "",
            .text = "the term of `delta_sph`, named after its paper",
            .fallback = "`fourtakas2019`; `antuono2010` for several liquids"});
  v.number("delta", s.delta, {.unit = "", .text = "δ, its strength; `delta_sph` only", .min = 0});
  v.number("background_pressure", s.background_pressure,
           {.unit = "Pa",
            .text = "added to the pressure, so that it is positive everywhere in a flow that fills "
                    "its space; `wcsph` and `delta_sph`",
            .min = 0});
  v.number("speed_limit", s.speed_limit,
           {.unit = "m/s",
            .text = "faster particles are slowed to it (scheme `article` only)",
            .min = 0,
            .above = true,
            .fallback = "none"});
  pressure_keys(v, s);
  solver_force_keys(v, s);
}

}  // namespace

Words solver_words() {
  static const std::vector<const char*> names = [] {
    std::vector<const char*> list;
    for (const SolverMethod* m : solver_methods()) list.push_back(m->name);
    return list;
  }();
  return names;
}

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
    v.texts(
        "body_force", s.domain.body_force,
        {.unit = "m/s²",
         .text = "acceleration beside gravity, a function for each axis of x, y, z [m] and t "
                 "[s]: `[\"9.81*sin(t)\", \"0\"]`; pi, + - * / ^, sin, cos, tan, exp, sqrt, abs, "
                 "min, max and more, `(t < 1 ? 2 : 0)`",
         .fallback = "none"});
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
  v.tables("inlet", "Where liquid comes in: `[inlet]` for one, `[[inlet]]` for several.", s.inlet,
           [&](Scene::Inlet& in) { inlet_keys(v, in); });
  v.tables("outlet", "Where liquid leaves: `[outlet]` for one, `[[outlet]]` for several.", s.outlet,
           [&](Scene::Outlet& out) {
             outlet_keys(v, out);
             region_keys(
                 v, out, Words(shape_words).first(4),
                 {.unit = "",
                  .text = "`box`, `sphere` (in 2D a disc), `cylinder` (3D) or `plane`; a "
                          "particle that is in it after a step is taken away"},
                 {.unit = "", .text = "`inside` of the shape, or the domain `outside` of it"});
           });
  v.tables("counter",
           "Counts what goes through a piece of a plane, or the whole plane: `[counter]` for one, "
           "`[[counter]]` for several.",
           s.counter, [&](Scene::Counter& c) { counter_keys(v, c); });
  v.tables("probe",
           "Where the fluid is asked while it flows: `[probe]` for one, `[[probe]]` for several; "
           "each fills probes/NAME.csv.",
           s.probe, [&](Scene::Probe& p) { probe_keys(v, p); });
  body_keys(v, s);
  v.section("solver", "The method and what computes it.", [&] { solver_keys(v, s.solver); });
  v.section("air", "What the liquid flies through.", [&] { air_keys(v, s.air); });
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
    v.boolean("retry", s.time.retry,
              {.unit = "",
               .text = "whether a step whose solve does not converge is taken back, and taken in "
                       "halves; pressure solvers"});
    v.choice("integrator", s.time.integrator, integrator_words,
             {.unit = "",
              .text = "how a step moves the particles; the pressure solvers have their own",
              .fallback = "`symplectic_euler` for `wcsph`, else `leapfrog`"});
  });
  output_keys(v, s);
}

}  // namespace freshet
