// SPDX-License-Identifier: MIT
#pragma once
#include <string>
#include <vector>

#include "freshet/simulation.h"

namespace freshet {

/// The first line of observables.csv: what each column is called, "NAME [UNIT]".
std::string observables_header(const Scene& scene);

/// The line of this moment. `wall_forces` are Simulation::wall_forces(), which are the mean since
/// they were last asked for, and so are the rates of `flows`, Simulation::flows(). Costs a pass
/// over the particles, and two that look for the fastest particle and the greatest acceleration
/// (Simulation::bounds).
std::string observables_line(Simulation& simulation, const std::vector<Vector>& wall_forces,
                             const std::vector<Flow>& flows = {});

}  // namespace freshet
