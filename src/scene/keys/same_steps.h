// SPDX-License-Identifier: MIT
#pragma once
#include <string>

namespace freshet {

/// Whether a step depends on a key, such as "fluid[0].viscosity". It does not depend on time.end,
/// title, description and the keys of output, surface, picture, camera and checks.
bool steps_depend_on(const std::string& key);

/// The first key on which steps depend and that differs between two scenes; empty if there is none.
/// Excepted are solver.backend, which does not change a bit, and the names of files, since a run
/// reads copies. Throws Error (kind scene) at `name_a` or `name_b` for a syntax error.
std::string differing_key(const std::string& a, const std::string& name_a, const std::string& b,
                          const std::string& name_b);

}  // namespace freshet
