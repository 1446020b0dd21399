// SPDX-License-Identifier: MIT
#pragma once
#include "freshet/scene.h"

namespace freshet {

/// The size of the data files of one time, in all formats of the scene [bytes]. The size of text is
/// estimated from the usual length of its numbers; float16 is assumed to hold every field.
double data_bytes(const Scene& scene, double particles);

}  // namespace freshet
