// SPDX-License-Identifier: MIT
#pragma once
#include "scene/model/setup.h"

namespace freshet {

/// Samples the bodies of a scene with its defaults filled in.
template <int D> void sample_bodies(const Scene& scene, Sample& all);

extern template void sample_bodies<2>(const Scene&, Sample&);
extern template void sample_bodies<3>(const Scene&, Sample&);

}  // namespace freshet
