// SPDX-License-Identifier: MIT
/// The initial state of a fluid: its free surface, velocity and pressure, and the run from which it
/// starts. `at` is the path of the fluid, "fluid[0]."
#pragma once
#include "scene/check/findings.h"

namespace freshet {

/// False if the free surface is invalid, so that the fluid has no places.
bool check_surface(const Scene& scene, const Scene::Fluid& fluid, const std::string& at,
                   Findings& out);
/// fluid.surface over the shape; requires a shape that check_region accepts.
bool check_surface_height(const Scene& scene, const Scene::Fluid& fluid, const std::string& at,
                          Findings& out);
void check_velocity_field(const Scene& scene, const Scene::Fluid& fluid, const std::string& at,
                          Findings& out);
void check_pressure(const Scene& scene, const Scene::Fluid& fluid, const std::string& at,
                    Findings& out);
/// The points of the run's frame that the fluid starts from; empty if they are invalid.
std::optional<PointCloud> check_run(const Scene& scene, const Scene::Fluid& fluid,
                                    const std::string& at, Findings& out);
/// Reports the keys of a run that a fluid sets although it starts from none.
void check_no_run(const std::string& at, Findings& out);

}  // namespace freshet
