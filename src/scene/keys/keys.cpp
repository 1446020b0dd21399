// SPDX-License-Identifier: MIT
#include "scene/keys/keys.h"

#include "scene/keys/keys_bodies.h"
#include "scene/keys/keys_forces.h"
#include "scene/keys/keys_inlets.h"
#include "scene/keys/keys_output.h"
#include "scene/keys/keys_probes.h"
#include "scene/keys/keys_solver.h"
#include "scene/keys/keys_whitewater.h"

namespace freshet {

void region_keys(KeyVisitor& v, Scene::Region& r, Words shapes, const KeyDoc& shape,
                 const KeyDoc& side) {
  v.choice("shape", r.shape, shapes, shape);
  v.choice("side", r.side, side_words, side);
  v.vector("min", r.min, {.unit = "m", .text = "lower corner of a box", .fallback = "none"});
  v.vector("max", r.max, {.unit = "m", .text = "upper corner of a box", .fallback = "none"});
  v.vector("center", r.center,
           {.unit = "m", .text = "centre of a sphere or cylinder", .fallback = "none"});
  v.number("radius", r.radius,
           {.unit = "m",
            .text = "radius of a sphere or cylinder",
            .min = 0,
            .above = true,
            .fallback = "none"});
  v.vector("axis", r.axis,
           {.unit = "",
            .text = "direction of a cylinder; its length is ignored",
            .fallback = "along y"});
  v.number(
      "length", r.length,
      {.unit = "m", .text = "length of a cylinder", .min = 0, .above = true, .fallback = "none"});
  v.vector("point", r.point, {.unit = "m", .text = "any point of a plane", .fallback = "none"});
  v.vector("normal", r.normal,
           {.unit = "",
            .text = "normal of a plane, pointing out of `inside`; its length is ignored",
            .fallback = "none"});
}

void file_keys(KeyVisitor& v, Scene::Region& r) {
  v.text("file", r.file,
         {.unit = "",
          .text = "file of points or of the corners of a polygon (`*.csv`, `*.ply`, `*.vtk`, "
                  "`*.vtp`, `*.vtu`, `*.xyz`, `*.bgeo`, `*.bhclassic`), or of a mesh (`*.stl`, "
                  "`*.obj`, `*.ply`), relative to the scene",
          .fallback = "none"});
  v.vectors("points", r.points,
            {.unit = "m",
             .text = "corners of a polygon in order, `[[x, y], [x, y], ...]`, if they are not in "
                     "`file`",
             .fallback = "none"});
  v.number(
      "base", r.base,
      {.unit = "m",
       .text = "height of a horizontal base that closes the corners of a polygon, so that they "
               "may be an open line such as a sea bed",
       .fallback = "none"});
  v.number(
      "scale", r.scale,
      {.unit = "m",
       .text = "length of one unit of a mesh, polygon or file of points: 0.001 for millimetres",
       .min = 0,
       .above = true});
  static constexpr std::size_t about_axes[] = {3};
  v.components("rotation", r.rotation, about_axes,
               {.unit = "°",
                .text = "rotation of a box about its centre, or of a mesh, polygon or file of "
                        "points about the origin, after scaling: in 2D a number, counterclockwise; "
                        "in 3D about x, "
                        "then y, then z; [-90, 0, 0] turns z upwards into y upwards",
                .fallback = "none"});
  v.vector("translation", r.translation,
           {.unit = "m",
            .text = "translation of a mesh, polygon or file of points, after rotation",
            .fallback = "none"});
}

namespace {

void fluid_keys(KeyVisitor& v, Scene::Fluid& f) {
  region_keys(
      v, f, shape_words,
      {.unit = "", .text = "shape of the fluid; `cylinder` and `mesh` in 3D only, `polygon` in 2D"},
      {.unit = "", .text = "`inside` of the shape, or the domain `outside` of it"});
  file_keys(v, f);
  v.vector("from", f.from,
           {.unit = "m", .text = "first particle of a lattice", .fallback = "none"});
  v.counts("count", f.count,
           {.unit = "",
            .text = "number of particles of a lattice along x, y and z",
            .min = 1,
            .fallback = "none"});
  v.text("surface", f.surface,
         {.unit = "m",
          .text = "height of the free surface as a function of x, in 3D of x and z, such as "
                  "`\"0.3 + 0.02*cos(2*pi*x/1.36)\"`; the fluid is the part of the shape below it, "
                  "of the domain if `min` and `max` of a box are not set",
          .fallback = "none"});
  v.text("from_run", f.from_run,
         {.unit = "",
          .text = "folder of a run, or one of its data files, relative to the scene: the fluid "
                  "starts as it was there",
          .fallback = "none"});
  v.number("time", f.time,
           {.unit = "s",
            .text = "time in the run of `from_run`; there must be a data file at this time",
            .min = 0,
            .fallback = "that of the last data file"});
  v.integer("frame", f.frame,
            {.unit = "",
             .text = "number of a data file of the run instead: 12 is data/frame_0012.vtp",
             .min = 0,
             .fallback = "the last"});
  v.integer("liquid", f.liquid,
            {.unit = "",
             .text = "which liquid of the run this fluid takes, counted from 0 in the order of its "
                     "fluids; required if the run has several",
             .min = 0,
             .fallback = "the only one"});
  v.vector("velocity", f.velocity,
           {.unit = "m/s", .text = "initial velocity", .fallback = "at rest"});
  v.texts("velocity_field", f.velocity_field,
          {.unit = "m/s",
           .text = "initial velocity as functions instead: one of x, y, z [m] per axis, such as "
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
          .text = "`#rrggbb`; used by picture.color_by `liquid`",
          .fallback = "blue, amber, green and so on"});
  fluid_force_keys(v, f);
  v.choice("pressure", f.pressure, pressure_words,
           {.unit = "",
            .text = "initial pressure: `zero`, or `hydrostatic` from the weight of the fluid above "
                    "(box, lattice and plane; a box below `surface`, too)"});
  v.text("pressure_field", f.pressure_field,
         {.unit = "Pa",
          .text = "initial pressure as a function instead, of x, y, z [m], such as "
                  "`\"9810*(0.3 - y)\"`; not with `mueller2003`, `wcsph` and `pbf`, whose pressure "
                  "follows from the positions",
          .fallback = "none"});
  v.choice("outside", f.outside, outside_words,
           {.unit = "",
            .text = "particles that start outside the domain: `error`, or `clamp` (the first step "
                    "puts them onto the wall)"});
}

void wall_surface_keys(KeyVisitor& v, Slip& slip, double& restitution) {
  v.choice("slip", slip, slip_words,
           {.unit = "",
            .text = "`no_slip`: fluid sticks to the wall; `free_slip`: it slides (`ghost`, "
                    "`akinci2012` and `adami2012`)"});
  v.number("restitution", restitution,
           {.unit = "",
            .text = "fraction of the normal speed that a particle keeps when a wall reflects it "
                    "(`reflection`)",
            .min = 0,
            .max = 1});
}

void wall_keys(KeyVisitor& v, Scene::Wall& w) {
  v.text("name", w.name,
         {.unit = "", .text = "name of its forces in tables and reports", .fallback = "wall[k]"});
  region_keys(
      v, w, Words(shape_words).first(7),
      {.unit = "",
       .text = "shape of the wall; a `sphere` is a disc in 2D; `cylinder` and `mesh` in 3D only, "
               "`polygon` in 2D"},
      {.unit = "", .text = "side of the fluid: `outside` of an obstacle, `inside` of a tank"});
  file_keys(v, w);
  v.choice("method", w.method, method_words,
           {.unit = "",
            .text = "method of the wall, see [walls]; `ghost` only for a plane and the inside of a "
                    "box; points only with `monaghan2009`, `akinci2012` or `adami2012`",
            .fallback = "the solver's default of walls.method, not its value; `akinci2012` in "
                        "place of `adami2012` for points "
                        "and for meshes with holes"});
  wall_surface_keys(v, w.slip, w.restitution);
  v.vector("velocity", w.velocity,
           {.unit = "m/s",
            .text = "velocity of the surface, which slides along itself like a belt (`adami2012`)",
            .fallback = "at rest"});
}

void walls_keys(KeyVisitor& v, Scene::Walls& w) {
  v.choice("method", w.method, method_words,
           {.unit = "",
            .text = "method of the sides that are not set below",
            .fallback = "`reflection` for `mueller2003`, `adami2012` for `wcsph` and `delta_sph`, "
                        "else `akinci2012`"});
  const auto side = [&](const char* name, std::optional<WallMethod>& method, const char* text) {
    v.choice(name, method, method_words, {.unit = "", .text = text, .fallback = "walls.method"});
  };
  side("x_min", w.x_min, "side of minimum x");
  side("x_max", w.x_max, "side of maximum x");
  side("y_min", w.y_min, "bottom");
  side("y_max", w.y_max, "top");
  side("z_min", w.z_min, "side of minimum z (3D)");
  side("z_max", w.z_max, "side of maximum z (3D)");
  wall_surface_keys(v, w.slip, w.restitution);
}

}  // namespace

void measured_keys(KeyVisitor& v, Scene& s) {
  v.tables("counter",
           "Counts the flow through a plane, or through a piece of it: `[counter]` for one, "
           "`[[counter]]` for several.",
           s.counter, [&](Scene::Counter& c) { counter_keys(v, c); });
  v.tables("probe",
           R"(A measurement during the run: `[probe]` for one, `[[probe]]` for several. Each writes
probes/NAME.csv.

- `point`: fluid fraction, velocity, density and pressure at a point.
- `line`: these fields at `count` points of a line.
- `plane`: these fields at points of a rectangle along the axes.
- `surface`: how far the fluid reaches along a line. Upwards this is the water height,
  along the floor the position of the front.
- `wall`: the traction on a rectangle of a wall along the axes, in 2D on a segment.
  Traction is the force of the fluid per area; its normal component is the pressure on
  the wall.)",
           s.probe, [&](Scene::Probe& p) { probe_keys(v, p); });
}

void visit_keys(KeyVisitor& v, Scene& s) {
  v.text("title", s.title, {.unit = "", .text = "one line for `freshet scenes`"});
  v.text("description", s.description, {.unit = "", .text = "what the scene shows"});
  v.section(
      "domain", R"(The box that holds the fluid.

The functions of a scene (`body_force`, `fluid.surface`, `fluid.velocity_field`,
`fluid.pressure_field`, `body.position`, `body.angle`) know pi, + - * / ^, sin, cos,
tan, cosh, exp, sqrt, abs, min, max and more. `(t < 1 ? 2 : 0)` is 2 before t = 1 s, then 0.)",
      [&] {
        v.vector("min", s.domain.min,
                 {.unit = "m", .text = "lower corner", .fallback = "the origin"});
        v.vector("max", s.domain.max,
                 {.unit = "m",
                  .text = "upper corner; 2 numbers for a scene in 2D, 3 for 3D",
                  .required = true});
        v.vector(
            "gravity", s.domain.gravity,
            {.unit = "m/s²", .text = "gravitational acceleration", .fallback = "9.81 along −y"});
        v.texts("body_force", s.domain.body_force,
                {.unit = "m/s²",
                 .text = "acceleration in addition to gravity: one function of x, y, z [m] and t "
                         "[s] per axis, such as `[\"9.81*sin(t)\", \"0\"]`",
                 .fallback = "none"});
        v.choice("periodic", s.domain.periodic, axes_words, {.unit = "", .text = "periodic axes"});
      });
  v.section("particles", "Size and arrangement of the particles.", [&] {
    v.number("spacing", s.particles.spacing,
             {.unit = "m",
              .text = "distance of neighbours at the start",
              .min = 0,
              .above = true,
              .required = true});
    v.number("support_radius", s.particles.support_radius,
             {.unit = "m",
              .text = "radius at which the kernels end (h of Müller et al. 2003)",
              .min = 0,
              .above = true,
              .fallback = "2 × spacing"});
    v.number("mass", s.particles.mass,
             {.unit = mass_unit,
              .text = "mass of a particle (scheme `article` only)",
              .min = 0,
              .above = true,
              .fallback = "rest_density × spacing² in 2D, × spacing³ in 3D"});
    v.number("jitter", s.particles.jitter,
             {.unit = "m",
              .text = "maximum random displacement of each coordinate, uniform in both directions",
              .min = 0});
    v.integer(
        "seed", s.particles.seed,
        {.unit = "", .text = "seed of the random displacements", .min = 0, .max = 4294967295.0});
  });
  v.tables("fluid", R"(A volume of fluid: `[fluid]` for one, `[[fluid]]` for several.

- `box`: particles from `min` to `max`, the first half a spacing inside.
- `lattice`: `count` particles along the axes, the first at `from`.
- `sphere` (in 2D a disc), `cylinder` (3D), `plane` (the domain below it), `mesh` (3D,
  from `file`): a lattice fills the box around the shape, and the places inside the
  shape become particles.
- `points`: the particles of `file`.

Places in walls, bodies and the zones of inlets, or closer to them than half a spacing,
are excluded. Where a wall or body cuts the places of a shape, as many excluded places are
added again as fill its volume up to the surface, and the places near it are spread evenly.
In a scene with bodies, fewer are added where they would start more than 6 % too dense.
The places of a `lattice` stay as they are. The points of a file are excluded only inside
walls. `check` and `info` print the volume of the particles and that of the shape without
walls and bodies. `check` warns if they differ by more than 1 %, 2 % for a round shape or
a mesh, or 0.1 % for a box that the lattice does not divide.

The positions of a file, and its velocities if it has them, become particles. The first
line of a `*.csv` names the columns x, y, z, vx, vy, vz. Files of other programs have
an array such as `velocity`, `Vel` or `U`. docs/data_files.md lists formats and names.
`check` warns of columns and arrays that are not used.

`surface` cuts a shape by a free surface. `from_run` starts from the state of another run.
docs/initial_states.md has examples of both.)",
           s.fluid, [&](Scene::Fluid& f) { fluid_keys(v, f); });
  v.tables("wall", R"(An obstacle or a tank: `[wall]` for one, `[[wall]]` for several.

A mesh with holes is a sheet. No particle crosses it, nor a wall of points.
[fluid] describes the files of points.)",
           s.wall, [&](Scene::Wall& w) { wall_keys(v, w); });
  v.tables("inlet", R"(An opening where liquid enters: `[inlet]` for one, `[[inlet]]` for several.

With `recycle` an inlet has no other supply: liquid that leaves through the outlet
enters again here, in whole layers. A layer enters as soon as the one before has made
room.)",
           s.inlet, [&](Scene::Inlet& in) { inlet_keys(v, in); });
  v.tables("outlet", R"(A region where liquid leaves: `[outlet]` for one, `[[outlet]]` for several.

After each step, the particles in it are removed.)",
           s.outlet, [&](Scene::Outlet& out) {
             outlet_keys(v, out);
             region_keys(
                 v, out, Words(shape_words).first(4),
                 {.unit = "",
                  .text = "shape of the region; a `sphere` is a disc in 2D; `cylinder` in 3D only"},
                 {.unit = "", .text = "`inside` of the shape, or the domain `outside` of it"});
           });
  measured_keys(v, s);
  body_keys(v, s);
  v.section(
      "solver",
      R"(The method, and the backend that computes it. docs/solvers.md and docs/forces.md explain
the choices.

- The pressure solvers are `pcisph`, `iisph`, `dfsph` and `pbf`. Each step iterates
  until the pressure keeps the density at rest.
- The density error is the larger of two means over the fluid: of max(0, ρ*/ρ0 − 1), and
  of what pressures hold further apart than at rest. The divergence error takes Δt
  Dρ/Dt/ρ0 in place of ρ*/ρ0 − 1.
- Viscosity: `artificial` has a strength of its own, `artificial_viscosity`; the other
  methods take `fluid.viscosity`. `monaghan2005` and `morris1997` limit the time step.
  `weiler2018` solves for the velocities and does not limit it.
- Surface tension: `morris2000` acts by the curvature of the surface, with σ in N/m.
  `akinci2013` acts by the attraction of particles near the surface, for splashes and
  wetted walls.
- Particle shifting: `lind2012` shifts by the same displacement in each step, `sun2017`
  in proportion to the speed of the flow, `adami2013` by a pressure that moves the
  particles but not the flow.)",
      [&] { solver_keys(v, s.solver); });
  v.section("air", "The air around the liquid.", [&] { air_keys(v, s.air); });
  whitewater_keys(v, s);
  v.section("walls", R"(The sides of the domain, and the methods of walls.

- `open`: the fluid leaves, and is removed and counted (docs/flows.md).
- `reflection`: particles are reflected.
- `ghost`: mirror images of the fluid.
- `monaghan2009`: boundary particles that repel, after Monaghan & Kajtar 2009.
- `akinci2012`: boundary particles after Akinci et al. 2012.
- `adami2012`: layers of boundary particles after Adami et al. 2012, not with the
  pressure solvers. If it is `walls.method` or its default, bodies are made of such
  layers, too.)",
            [&] { walls_keys(v, s.walls); });
  v.section("time", "Duration and time step.", [&] {
    v.number("end", s.time.end,
             {.unit = "s", .text = "simulated time", .min = 0, .above = true, .required = true});
    v.number_or_word("step", s.time.step, s.time.adaptive, "adaptive",
                     {.unit = "s",
                      .text = "time step; a run takes round(end/step) steps. `\"adaptive\"`: the "
                              "longest stable step, at most step_max",
                      .min = 0,
                      .above = true,
                      .required = true});
    v.number("step_max", s.time.step_max,
             {.unit = "s",
              .text = "maximum of an adaptive step",
              .min = 0,
              .above = true,
              .fallback = "none; required for adaptive steps"});
    v.boolean("retry", s.time.retry,
              {.unit = "",
               .text = "roll back a step whose solve did not converge, and repeat it in halves; "
                       "pressure solvers"});
    v.choice("integrator", s.time.integrator, integrator_words,
             {.unit = "",
              .text = "time integration; the pressure solvers have their own",
              .fallback = "`symplectic_euler` for `wcsph`, else `leapfrog`"});
  });
  output_keys(v, s);
}

}  // namespace freshet
