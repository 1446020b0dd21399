// SPDX-License-Identifier: MIT
#pragma once
#include "freshet/scene.h"

namespace freshet {

/// What the data files of one moment take, in all the formats of the scene [bytes]; text by the
/// usual length of its numbers, and float16 as if every field fits it.
double data_bytes(const Scene& scene, double particles);

}  // namespace freshet
