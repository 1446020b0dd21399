// SPDX-License-Identifier: MIT
#include "scene/keys/keys_solver.h"

#include <map>
#include <vector>

#include "freshet/force_method.h"
#include "scene/keys/keys_forces.h"

namespace freshet {
namespace {

/// The keys of the pressure solvers.
void pressure_keys(KeyVisitor& v, Scene::Solver& s) {
  v.number("density_tolerance", s.density_tolerance,
           {.unit = "",
            .text = "maximum density error of a solve, as a fraction of ρ0; pressure solvers",
            .min = 1e-6,
            .max = 0.1,
            .fallback = "0.0003 where solver.density_correction is `gradual`; else 0.0001 for "
                        "`dfsph`, 0.001 for other solvers"});
  v.number("divergence_tolerance", s.divergence_tolerance,
           {.unit = "",
            .text = "maximum divergence error of a solve, as a fraction of ρ0; `dfsph` only",
            .min = 1e-6,
            .max = 1,
            .fallback = "0.00003; 0.001 if solver.density_correction is `at_once`"});
  v.choice(
      "density_correction", s.density_correction, correction_words,
      {.unit = "",
       .text = "how `pcisph`, `iisph` and `dfsph` remove an error of the density: `gradual`, a "
               "fifth in a step, while the velocity stays divergence-free, which keeps waves and "
               "stillness; or `at_once`, as in their papers",
       .fallback = "`gradual` for `dfsph`, else `at_once`"});
  v.integer("min_iterations", s.min_iterations,
            {.unit = "",
             .text = "minimum number of iterations of a solve; pressure solvers",
             .min = 1,
             .max = 1e6,
             .fallback = "1; 4 for the divergence solve of `dfsph` in water almost at rest, where "
                         "solver.density_correction is `gradual`"});
  v.integer("max_iterations", s.max_iterations,
            {.unit = "",
             .text = "maximum number of iterations of a solve; pressure solvers",
             .min = 1,
             .max = 1e6});
  v.boolean("warm_start", s.warm_start,
            {.unit = "",
             .text = "start a solve from the pressures of the last step; `iisph` and `dfsph`"});
  v.choice("iteration", s.iteration, iteration_words,
           {.unit = "",
            .text = "iteration of `dfsph`: `jacobi` as in the paper, or accelerated (`nesterov`), "
                    "which needs fewer iterations"});
  v.number("xsph", s.xsph,
           {.unit = "",
            .text = "share of the velocity differences to the neighbours, along the lines between "
                    "them, that is removed in the time 0.25 √(h/g), or in a step that is "
                    "longer; without gravity in ten steps; pressure solvers",
            .min = 0,
            .max = 1});
}

}  // namespace

void solver_keys(KeyVisitor& v, Scene::Solver& s) {
  v.choice("name", s.name, solver_words(),
           {.unit = "", .text = "the method, named after its paper"});
  v.choice("scheme", s.scheme, scheme_words,
           {.unit = "",
            .text = "`paper`: the equations as published; `article`: the variant of the teaching "
                    "article, with five differences (docs/article.md)"});
  v.choice(
      "backend", s.backend, backend_words,
      {.unit = "", .text = "`cpu`: threads and SIMD; `reference`: scalar, with the same bits"});
  v.choice("search", s.search, search_words,
           {.unit = "",
            .text = "neighbour search: `grid` is O(N), `all_pairs` O(N²), with the same bits"});
  v.choice("neighbor_order", s.neighbor_order, order_words,
           {.unit = "",
            .text = "order of summation over neighbours: by cell, then id; or by id, like a loop "
                    "over all particles"});
  v.number("stiffness", s.stiffness,
           {.unit = "m²/s²",
            .text = "k in p = k(ρ − ρ0), the square of the speed of sound; `mueller2003` only",
            .min = 0,
            .above = true,
            .fallback = "(10 · √(2 g · height of the domain))²"});
  v.choice("kernel", s.kernel, kernel_words,
           {.unit = "", .text = "smoothing kernel; not for `mueller2003`, which has its own"});
  v.number("sound_speed", s.sound_speed,
           {.unit = "m/s",
            .text = "speed of sound c in Tait's equation of state; `wcsph` and `delta_sph`",
            .min = 0,
            .above = true,
            .fallback = "ten times the fastest flow: a fall √(v² + 2 g H) from the top of the "
                        "fluid to the end of the domain, a moved body, a wall"});
  v.number("artificial_viscosity", s.artificial_viscosity,
           {.unit = "",
            .text = "α of Monaghan's artificial viscosity; `wcsph` and `delta_sph`",
            .min = 0,
            .fallback = "0.05; 0 if solver.viscosity_method is not `artificial`"});
  v.choice("density_diffusion", s.density_diffusion, diffusion_words,
           {.unit = "",
            .text = "density diffusion of `delta_sph`, named after its paper",
            .fallback = "`fourtakas2019`; `antuono2010` for several liquids"});
  v.number(
      "delta", s.delta,
      {.unit = "", .text = "δ, strength of the density diffusion; `delta_sph` only", .min = 0});
  v.number("acoustic_damping", s.acoustic_damping,
           {.unit = "",
            .text = "bulk viscosity over h·c, which damps sound and not the flow; `delta_sph` only",
            .min = 0,
            .max = 1});
  v.number("background_pressure", s.background_pressure,
           {.unit = "Pa",
            .text = "constant added to the pressure, to keep it positive in flows without a free "
                    "surface; `wcsph` and `delta_sph`",
            .min = 0});
  v.number("speed_limit", s.speed_limit,
           {.unit = "m/s",
            .text = "maximum speed of a particle (scheme `article` only)",
            .min = 0,
            .above = true,
            .fallback = "none"});
  pressure_keys(v, s);
  solver_force_keys(v, s);
}

Words solver_words() {
  static const std::vector<const char*> names = [] {
    std::vector<const char*> list;
    for (const SolverMethod* m : solver_methods()) list.push_back(m->name);
    return list;
  }();
  return names;
}

Words force_words(std::string_view key) {
  static const std::map<std::string_view, std::vector<const char*>> names = [] {
    std::map<std::string_view, std::vector<const char*>> lists;
    for (const ForceMethod& m : force_methods()) lists[m.key].push_back(m.name);
    return lists;
  }();
  return names.at(key);
}

}  // namespace freshet
