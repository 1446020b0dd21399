// SPDX-License-Identifier: MIT
#pragma once
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

/// The bodies of each step that a table has, in the order of Scene::body.
std::map<std::int64_t, std::vector<BodyState>> read_bodies(std::string_view table,
                                                           const Scene& scene);

}  // namespace freshet
