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
/// A line for each body of this moment.
std::string body_lines(const Simulation& simulation);

/// The bodies of each step that bodies.csv has, in the order of Scene::body. A last step without
/// all its rows is skipped: a run that was killed leaves one. Throws Error (kind scene) at
/// `file`:LINE for any other line that body_header and body_lines would not write.
std::map<std::int64_t, std::vector<BodyState>> read_bodies(std::string_view table,
                                                           const Scene& scene,
                                                           const std::string& file);

}  // namespace freshet
