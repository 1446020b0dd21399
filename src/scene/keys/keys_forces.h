// SPDX-License-Identifier: MIT
/// The keys of the forces beside pressure, a part of the table in keys.cpp.
#pragma once
#include "scene/keys/keys.h"

namespace freshet {

void fluid_force_keys(KeyVisitor& v, Scene::Fluid& f);
void solver_force_keys(KeyVisitor& v, Scene::Solver& s);
void air_keys(KeyVisitor& v, Scene::Air& a);

}  // namespace freshet
