// SPDX-License-Identifier: MIT
#include "freshet/force_method.h"

namespace freshet {

const std::vector<ForceMethod>& force_methods() {
  constexpr const char *viscosity = "solver.viscosity_method",
                       *tension = "solver.surface_tension_method",
                       *shifting = "solver.shifting_method", *vorticity = "solver.vorticity_method",
                       *drag = "air.drag";
  static const std::vector<ForceMethod> all{
      {viscosity, "artificial", "Monaghan 1992"},
      {viscosity, "monaghan2005", "Monaghan 2005"},
      {viscosity, "morris1997", "Morris, Fox and Zhu 1997"},
      {viscosity,
       "weiler2018",
       "Weiler et al. 2018",
       {"solver.viscosity_tolerance", "solver.viscosity_max_iterations"}},
      {tension, "none", ""},
      {tension,
       "akinci2013",
       "Akinci, Akinci and Teschner 2013",
       {"fluid.surface_tension", "fluid.adhesion"}},
      {tension, "morris2000", "Morris 2000", {"fluid.surface_tension"}},
      {shifting, "none", ""},
      {shifting, "lind2012", "Lind et al. 2012"},
      {shifting, "adami2013", "Adami, Hu and Adams 2013"},
      {shifting, "sun2017", "Sun et al. 2017"},
      {vorticity, "none", ""},
      {vorticity,
       "bender2017",
       "Bender et al. 2017",
       {"solver.vorticity_transfer", "solver.vorticity_inertia"}},
      {drag, "none", ""},
      {drag,
       "gissler2017",
       "Gissler et al. 2017",
       {"air.velocity", "air.density", "air.viscosity", "fluid.surface_tension"}}};
  return all;
}

}  // namespace freshet
