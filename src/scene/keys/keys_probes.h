// SPDX-License-Identifier: MIT
#pragma once
#include "scene/keys/keys.h"

namespace freshet {

void probe_keys(KeyVisitor& visitor, Scene::Probe& probe);

}  // namespace freshet
