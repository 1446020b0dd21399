// SPDX-License-Identifier: MIT
/// The names of solvers, kernels and other methods, as scenes and engines use them.
#pragma once

namespace freshet {

/// freshet/solver_method.h describes each.
enum class SolverName { mueller2003, wcsph, delta_sph, pcisph, iisph, dfsph, pbf };
enum class Scheme { paper, article };
enum class KernelName { cubic_spline, wendland_c2, wendland_c4, wendland_c6 };
enum class DensityDiffusion { none, fourtakas2019, antuono2010 };
enum class Iteration { jacobi, nesterov };
enum class DensityCorrection { gradual, at_once };
enum class WallMethod { open, reflection, monaghan2009, ghost, akinci2012, adami2012 };
enum class Slip { free_slip, no_slip };
enum class BackendName { cpu, reference };
enum class Search { grid, all_pairs };
enum class NeighborOrder { cell, id };
enum class ViscosityMethod { artificial, monaghan2005, morris1997, weiler2018 };
enum class SurfaceTensionMethod { none, akinci2013, morris2000 };
enum class ShiftingMethod { none, lind2012, adami2013, sun2017 };
enum class VorticityMethod { none, bender2017 };
enum class Drag { none, gissler2017 };

}  // namespace freshet
