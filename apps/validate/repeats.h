// SPDX-License-Identifier: MIT
/// Several runs of one resolution, whose starts differ in the last digits: what hangs on those
/// digits is chaos, not the method.
#pragma once
#include <vector>

#include "validate/validate.h"

namespace freshet {

/// The overrides that change the start of a repeat: positions by 1e-4 spacings, or another seed if
/// the scene has a jitter of its own. None for repeat 0.
std::vector<Override> changed_start(const Scene& scene, int repeat);

/// One run of the median of each result, the worse of two in the middle. If a repeat failed, that
/// repeat.
ValidationRun median_of(std::vector<ValidationRun> repeats);

}  // namespace freshet
