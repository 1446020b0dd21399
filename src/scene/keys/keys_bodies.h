// SPDX-License-Identifier: MIT
#pragma once
#include "scene/keys/keys.h"

namespace freshet {

/// Where a fluid, a wall or a body stands.
void region_keys(KeyVisitor& visitor, Scene::Region& region, Words shapes, const KeyDoc& shape,
                 const KeyDoc& side);
/// Of what may be read from a file.
void file_keys(KeyVisitor& visitor, Scene::Region& region);

/// The keys of [[body]] and [[joint]].
void body_keys(KeyVisitor& visitor, Scene& scene);

}  // namespace freshet
