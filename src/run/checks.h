// SPDX-License-Identifier: MIT
#pragma once
#include <vector>

#include "freshet/report.h"
#include "freshet/scene.h"

namespace freshet {

/// What a scene asks of a run's end, against what came out.
std::vector<CheckResult> evaluate(const Scene::Checks& checks, const Report& report);

}  // namespace freshet
