// SPDX-License-Identifier: MIT
#include "scene/keys.h"

namespace freshet {
namespace {

void fluid_keys(KeyVisitor& v, Scene::Fluid& f) {
  v.choice("shape", f.shape, shape_words,
           {.unit = "",
            .text = "`box`: particles fill min to max, the first half a spacing inside; "
                    "`lattice`: `count` particles, the first at `from`"});
  v.vector("min", f.min, {.unit = "m", .text = "lower corner of a box", .fallback = "none"});
  v.vector("max", f.max, {.unit = "m", .text = "upper corner of a box", .fallback = "none"});
  v.vector("from", f.from,
           {.unit = "m", .text = "first particle of a lattice", .fallback = "none"});
  v.counts(
      "count", f.count,
      {.unit = "", .text = "particles of a lattice along x and y", .min = 1, .fallback = "none"});
  v.vector("velocity", f.velocity, {.unit = "m/s", .text = "velocity at the start"});
  v.number("rest_density", f.rest_density,
           {.unit = "kg/m²", .text = "density at zero pressure (ρ0)", .min = 0, .above = true});
  v.number("viscosity", f.viscosity, {.unit = "Pa s", .text = "dynamic viscosity (μ)", .min = 0});
  v.choice("outside", f.outside, outside_words,
           {.unit = "",
            .text = "a particle that starts outside the domain is an error, or is left to the "
                    "walls (`clamp`: the first step puts it onto the wall)"});
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
            .text = "k in p = k(ρ − ρ0), the square of the speed of sound",
            .min = 0,
            .above = true,
            .fallback = "(10 · √(2 |g| · height of the domain))²"});
  v.number("speed_limit", s.speed_limit,
           {.unit = "m/s",
            .text = "faster particles are slowed to it (scheme `article` only)",
            .min = 0,
            .above = true,
            .fallback = "none"});
}

void output_keys(KeyVisitor& v, Scene& s) {
  v.section("output", "What a run writes, and how often.", [&] {
    v.integer("frame_every_steps", s.output.frame_every_steps,
              {.unit = "steps",
               .text = "a frame after step 0, after every so many steps, and after the last",
               .min = 1,
               .max = 1e9,
               .fallback = "a tenth of the run"});
    v.integer("observables_every_steps", s.output.observables_every_steps,
              {.unit = "steps",
               .text = "a line of observables.csv after step 0, every so many steps, and the last",
               .min = 1,
               .max = 1e9,
               .fallback = "a hundredth of the run"});
  });
  v.section("picture", "How a frame is drawn.", [&] {
    v.integer("width", s.picture.width, {.unit = "px", .text = "width", .min = 32, .max = 8192});
    v.integer("height", s.picture.height, {.unit = "px", .text = "height", .min = 32, .max = 8192});
    v.integer("dot_radius", s.picture.dot_radius,
              {.unit = "px", .text = "radius of a particle's soft dot", .min = 1, .max = 200});
  });
  v.section("checks", "What must hold at the end; a run whose check fails exits with 1.", [&] {
    v.integer("out_of_bounds_max", s.checks.out_of_bounds_max,
              {.unit = "",
               .text = "most particles further than a support radius outside the domain",
               .min = 0,
               .fallback = "unchecked"});
    v.number("density_mean_min", s.checks.density_mean_min,
             {.unit = "kg/m²", .text = "mean density is above", .fallback = "unchecked"});
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
  });
}

}  // namespace

void visit_keys(KeyVisitor& v, Scene& s) {
  v.text("title", s.title, {.unit = "", .text = "a line for the list of scenes"});
  v.text("description", s.description, {.unit = "", .text = "what the scene shows"});
  v.section("domain", "The box that the fluid lives in.", [&] {
    v.vector("min", s.domain.min, {.unit = "m", .text = "lower corner"});
    v.vector("max", s.domain.max, {.unit = "m", .text = "upper corner", .required = true});
    v.vector("gravity", s.domain.gravity, {.unit = "m/s²", .text = "acceleration of gravity"});
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
              .fallback = "rest_density × spacing²"});
    v.number("jitter", s.particles.jitter,
             {.unit = "m",
              .text = "each coordinate moves by a uniform random number up to this, either way",
              .min = 0});
    v.integer("seed", s.particles.seed,
              {.unit = "", .text = "seed of the jitter", .min = 0, .max = 4294967295.0});
  });
  v.sections("fluid", "A block of fluid: `[fluid]` for one, `[[fluid]]` for several.", s.fluid,
             [&](Scene::Fluid& f) { fluid_keys(v, f); });
  v.section("solver", "The method and what computes it.", [&] { solver_keys(v, s.solver); });
  v.section("walls", "The sides of the domain.", [&] {
    v.number("restitution", s.walls.restitution,
             {.unit = "",
              .text = "share of the normal speed that a particle keeps when a wall turns it back",
              .min = 0,
              .max = 1});
  });
  v.section("time", "How long, and in what steps.", [&] {
    v.number("end", s.time.end,
             {.unit = "s", .text = "simulated time", .min = 0, .above = true, .required = true});
    v.number("step", s.time.step,
             {.unit = "s",
              .text = "time step; the run takes round(end/step) steps",
              .min = 0,
              .above = true,
              .required = true});
  });
  output_keys(v, s);
}

}  // namespace freshet
