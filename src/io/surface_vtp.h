// SPDX-License-Identifier: MIT
#pragma once
#include <string>

#include "core/surface_points.h"

namespace freshet {

/// VTK XML PolyData of the load on surfaces: normal, traction, pressure, part, and the area of each
/// point.
std::string encode_surface(const SurfacePoints& surface, double time, std::int64_t step);

}  // namespace freshet
