// SPDX-License-Identifier: MIT
#pragma once

namespace freshet::cli {

/// From now on the first Ctrl-C (or SIGTERM) is noted only, for stop_asked; a second one kills. The
/// end of the terminal (SIGHUP) is noted only, however often it is sent.
void catch_interrupts();
bool stop_asked();

}  // namespace freshet::cli
