// SPDX-License-Identifier: MIT
#pragma once

namespace freshet::cli {

/// Lets the threads of a command that computes sleep soon after a parallel loop. libgomp reads how
/// long they spin before main begins, so the program executes itself again with that setting. It
/// does nothing if OMP_WAIT_POLICY or GOMP_SPINCOUNT is set, or if it fails.
void let_idle_threads_sleep(int argc, char** argv);

}  // namespace freshet::cli
