// SPDX-License-Identifier: MIT
#pragma once
#include "scene/keys/keys.h"

namespace freshet {

void whitewater_keys(KeyVisitor& visitor, Scene& scene);

}  // namespace freshet
