// SPDX-License-Identifier: MIT
#pragma once
#include <functional>

#include "scene/sample/faces.h"

namespace freshet {

/// Spreads places near the `walls` among the faces evenly, about `spacing` apart and half a spacing
/// from each face [Colagrossi, Bouscasse, Antuono, Marrone 2012, particle packing]. They repel each
/// other and their mirror images behind the faces. Places far from the walls stay. A place never
/// moves to where `allowed` is false. Returns the density of the densest place near the walls, over
/// that of a lattice.
template <int D>
double relax(std::vector<Vec<D, double>>& places, const std::vector<Face<D>>& faces,
             const std::vector<Face<D>>& walls, double spacing,
             const std::function<bool(Vec<D, double>)>& allowed);

}  // namespace freshet
