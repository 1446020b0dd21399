// SPDX-License-Identifier: MIT
#pragma once
#include <cstdint>
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "freshet/simulation.h"

namespace freshet {

/// The first line of bodies.csv; empty of a scene without bodies.
std::string body_header(const Scene& scene);
/// A line for each body of a frame.
std::string body_lines(const Frame& frame, const Scene& scene);

/// The bodies at each time [s] that bodies.csv has, in the order of Scene::body. A last time
/// without all its rows is skipped: a run that was killed leaves one. Throws Error (kind scene) at
/// `file`:LINE for any other line that body_header and body_lines would not write.
std::map<double, std::vector<BodyState>> read_bodies(std::string_view table, const Scene& scene,
                                                     const std::string& file);

}  // namespace freshet
