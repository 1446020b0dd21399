// SPDX-License-Identifier: MIT
#pragma once
#include "scene/keys/keys.h"

namespace freshet {

/// The shape and place of a fluid, a wall, an outlet or a body.
void region_keys(KeyVisitor& visitor, Scene::Region& region, Words shapes, const KeyDoc& shape,
                 const KeyDoc& side);
/// The keys of a region that is read from a file.
void file_keys(KeyVisitor& visitor, Scene::Region& region);

/// The keys of [[body]] and [[joint]].
void body_keys(KeyVisitor& visitor, Scene& scene);

}  // namespace freshet
