// SPDX-License-Identifier: MIT
#pragma once
#include <string>

namespace freshet {

/// The JSON Schema of scene files, which editors use for completion.
std::string scene_schema();
/// The reference of all scene keys in Markdown (docs/scene.md).
std::string scene_reference();

}  // namespace freshet
