// SPDX-License-Identifier: MIT
#pragma once
#include <string>

namespace freshet {

/// The JSON Schema of scene files, for editors.
std::string scene_schema();
/// The reference of every scene key in Markdown (docs/scene.md).
std::string scene_reference();

}  // namespace freshet
