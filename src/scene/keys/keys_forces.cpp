// SPDX-License-Identifier: MIT
#include "scene/keys/keys_forces.h"

#include "scene/keys/keys_output.h"

namespace freshet {

void fluid_force_keys(KeyVisitor& v, Scene::Fluid& f) {
  v.number("surface_tension", f.surface_tension,
           {.unit = "N/m",
            .text = "surface tension σ, 0.0728 for water; used with solver.surface_tension_method "
                    "or air.drag",
            .min = 0,
            .above = true,
            .fallback = "none"});
  v.number("adhesion", f.adhesion,
           {.unit = "",
            .text = "attraction by walls of `akinci2012`, as a multiple of the liquid's own; used "
                    "with solver.surface_tension_method",
            .min = 0});
}

void solver_force_keys(KeyVisitor& v, Scene::Solver& s) {
  v.choice(
      "viscosity_method", s.viscosity_method, force_words("solver.viscosity_method"),
      {.unit = "",
       .text = "viscosity; `artificial` only for `wcsph` and `delta_sph`; not for `mueller2003`",
       .fallback = "`artificial` for `wcsph` and `delta_sph`, else `monaghan2005`"});
  v.number(
      "viscosity_tolerance", s.viscosity_tolerance,
      {.unit = "",
       .text =
           "maximum residual of `weiler2018`, as a fraction of the change by viscosity in the step",
       .min = 1e-6,
       .max = 0.1});
  v.integer("viscosity_max_iterations", s.viscosity_max_iterations,
            {.unit = "",
             .text = "maximum number of iterations of `weiler2018` per step",
             .min = 1,
             .max = 1e6});
  v.choice("surface_tension_method", s.surface_tension_method,
           force_words("solver.surface_tension_method"),
           {.unit = "", .text = "surface tension; not for `mueller2003`"});
  v.choice("shifting_method", s.shifting_method, force_words("solver.shifting_method"),
           {.unit = "",
            .text = "shifts particles away from crowded places, for flows that fill their space; "
                    "not for `mueller2003`"});
  v.choice("vorticity_method", s.vorticity_method, force_words("solver.vorticity_method"),
           {.unit = "",
            .text = "`bender2017`: particles spin, and return to the flow the rotation that eddies "
                    "lose; not for `mueller2003`"});
  v.number("vorticity_transfer", s.vorticity_transfer,
           {.unit = "m²/s",
            .text = "transfer coefficient ν_t of `bender2017`, between flow and spin",
            .min = 0,
            .above = true,
            .fallback = "none; required for `bender2017`"});
  v.number("vorticity_inertia", s.vorticity_inertia,
           {.unit = "m²",
            .text = "inertia Θ of `bender2017`: the larger, the slower the spin follows the flow",
            .min = 0,
            .above = true,
            .fallback = "the square of the support radius"});
}

void air_keys(KeyVisitor& v, Scene::Air& a) {
  v.choice(
      "drag", a.drag, force_words("air.drag"),
      {.unit = "",
       .text =
           "`gissler2017`: air slows single drops and pushes the surface; not for `mueller2003`"});
  v.vector("velocity", a.velocity,
           {.unit = "m/s", .text = "velocity of the wind", .fallback = "at rest"});
  v.number("density", a.density,
           {.unit = density_unit, .text = "density of the air", .min = 0, .above = true});
  v.number("viscosity", a.viscosity,
           {.unit = "Pa s", .text = "dynamic viscosity of the air", .min = 0, .above = true});
}

}  // namespace freshet
