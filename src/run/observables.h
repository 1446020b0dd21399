// SPDX-License-Identifier: MIT
#pragma once
#include <string>
#include <vector>

#include "freshet/simulation.h"
#include "io/checkpoint.h"

namespace freshet {

/// Names of columns, each after a comma: the volume through a flow so far, and its mean rate.
std::string flow_columns(const Scene& scene, const std::string& name);
/// Names of columns, each after a comma: the force on a wall or body along each axis.
std::string force_columns(const Scene& scene, const std::string& name);

/// The first line of observables.csv: the names of the columns, "NAME [UNIT]".
std::string observables_header(const Scene& scene);

/// The row of this moment, with the results of Simulation::wall_forces and Simulation::flows. Costs
/// a pass over the particles, and two that look for the fastest particle and the greatest
/// acceleration (Simulation::bounds).
std::string observables_line(const Simulation& simulation, const std::vector<Vector>& wall_forces,
                             const std::vector<Flow>& flows = {},
                             const IntervalRecord& interval = {});

/// The forces on walls and bodies, whose statistics the table has if output.statistics is set.
std::vector<double> loads(const Simulation& simulation, const std::vector<Vector>& wall_forces);

}  // namespace freshet
