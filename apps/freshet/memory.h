// SPDX-License-Identifier: MIT
#pragma once

namespace freshet::cli {

/// Keeps memory in reserve until an allocation fails for the first time. A run that has used up its
/// memory needs some to end: it writes its tables and manifest, and closes its files.
void keep_memory_in_reserve();
/// Whether the reserve has been used. A run should end.
bool memory_ran_short();

}  // namespace freshet::cli
