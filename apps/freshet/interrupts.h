// SPDX-License-Identifier: MIT
#pragma once

namespace freshet::cli {

/// From now on the first Ctrl-C (or SIGTERM) is noted only, for stop_asked; a second one kills.
void catch_interrupts();
bool stop_asked();

}  // namespace freshet::cli
