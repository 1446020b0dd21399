// SPDX-License-Identifier: MIT
/// The keys of the solver, a part of the table in keys.cpp.
#pragma once
#include "scene/keys/keys.h"

namespace freshet {

void solver_keys(KeyVisitor& v, Scene::Solver& s);

}  // namespace freshet
