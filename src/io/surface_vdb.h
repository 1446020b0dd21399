// SPDX-License-Identifier: MIT
#pragma once
#include <string>

#include "io/surface_files.h"
#include "surface/fluid_grids.h"

namespace freshet {

/// A file of OpenVDB with the grids `surface` (signed distance [m], a level set), `density` (a fog
/// volume, 1 deep in the fluid) and `v` (velocity [m/s]), the latter two as 16-bit floats.
std::string encode_fluid_vdb(const FluidGrids& grids, const SurfaceTime& time);

}  // namespace freshet
