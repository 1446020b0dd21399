// SPDX-License-Identifier: MIT
#pragma once
#include "engine/plan.h"
#include "freshet/derived.h"

namespace freshet {

/// The numbers that an engine needs of a scene with its defaults filled in. `bodies` are those of
/// the scene, null if it has none; they must outlive the engine.
EnginePlan plan_of(const Scene& scene, const Derived& derived, Bodies* bodies, int threads);

}  // namespace freshet
