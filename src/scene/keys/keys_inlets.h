// SPDX-License-Identifier: MIT
#pragma once
#include "scene/keys/keys.h"

namespace freshet {

void inlet_keys(KeyVisitor& visitor, Scene::Inlet& inlet);
/// The keys of an outlet except those of its region.
void outlet_keys(KeyVisitor& visitor, Scene::Outlet& outlet);
void counter_keys(KeyVisitor& visitor, Scene::Counter& counter);

}  // namespace freshet
