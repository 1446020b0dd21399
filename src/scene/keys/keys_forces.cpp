// SPDX-License-Identifier: MIT
#include "scene/keys/keys_forces.h"

namespace freshet {

void fluid_force_keys(KeyVisitor& v, Scene::Fluid& f) {
  v.number("surface_tension", f.surface_tension,
           {.unit = "N/m",
            .text = "σ of the surface; 0.0728 is water's; read with "
                    "solver.surface_tension_method or air.drag",
            .min = 0,
            .above = true,
            .fallback = "none"});
  v.number("adhesion", f.adhesion,
           {.unit = "",
            .text = "how much walls of `akinci2012` attract the liquid, over how much it attracts "
                    "itself; read with solver.surface_tension_method",
            .min = 0});
}

void solver_force_keys(KeyVisitor& v, Scene::Solver& s) {
  v.choice("viscosity_method", s.viscosity_method, viscosity_words,
           {.unit = "",
            .text = "`artificial`: of a strength of its own (`wcsph` and `delta_sph`); the "
                    "others take fluid.viscosity: `monaghan2005` and `morris1997` bound the time "
                    "step, `weiler2018` solves for the velocities and does not; not for "
                    "`mueller2003`",
            .fallback = "`artificial` for `wcsph` and `delta_sph`, else `monaghan2005`"});
  v.number("viscosity_tolerance", s.viscosity_tolerance,
           {.unit = "",
            .text = "`weiler2018` iterates until what is left of its equations, as a share of "
                    "what viscosity changes in the step, is no more than this",
            .min = 1e-6,
            .max = 0.1});
  v.integer("viscosity_max_iterations", s.viscosity_max_iterations,
            {.unit = "",
             .text = "of `weiler2018` in a step, even if more is left by then",
             .min = 1,
             .max = 1e6});
  v.choice("surface_tension_method", s.surface_tension_method, tension_words,
           {.unit = "",
            .text = "how fluid.surface_tension acts: `morris2000` by the curvature of the surface, "
                    "so that σ is in N/m; `akinci2013` by what particles near it attract, for "
                    "splashes and walls that are wetted; not for `mueller2003`"});
  v.choice("shifting_method", s.shifting_method, shifting_words,
           {.unit = "",
            .text = "particles go on a little from where they crowd, for flows that fill their "
                    "space: `lind2012` by as much in each step, `sun2017` by as much as the flow "
                    "is fast, `adami2013` by a pressure that moves them and not the flow; not for "
                    "`mueller2003`"});
  v.choice("vorticity_method", s.vorticity_method, vorticity_words,
           {.unit = "",
            .text = "`bender2017`: particles spin, and give back to the flow what eddies lose; "
                    "not for `mueller2003`"});
  v.number("vorticity_transfer", s.vorticity_transfer,
           {.unit = "m²/s",
            .text = "ν_t of `bender2017`, from the flow to the spin and back",
            .min = 0,
            .above = true,
            .fallback = "none; `bender2017` needs it"});
  v.number("vorticity_inertia", s.vorticity_inertia,
           {.unit = "m²",
            .text = "Θ of `bender2017`: how slowly the spin follows the flow",
            .min = 0,
            .above = true,
            .fallback = "the square of the support radius"});
}

void air_keys(KeyVisitor& v, Scene::Air& a) {
  v.choice("drag", a.drag, drag_words,
           {.unit = "",
            .text = "`gissler2017`: the air slows single drops and pushes the surface; not for "
                    "`mueller2003`"});
  v.vector("velocity", a.velocity, {.unit = "m/s", .text = "the wind", .fallback = "at rest"});
  v.number("density", a.density, {.unit = "kg/m³", .text = "of the air", .min = 0, .above = true});
  v.number("viscosity", a.viscosity,
           {.unit = "Pa s", .text = "dynamic viscosity of the air", .min = 0, .above = true});
}

}  // namespace freshet
