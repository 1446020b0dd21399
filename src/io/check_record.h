// SPDX-License-Identifier: MIT
#pragma once
#include "io/checkpoint.h"

namespace freshet {

/// Checks the record of a run in a checkpoint, as another program can write one: counters, times,
/// and the names of tables, which must be below the run folder. Throws Error (kind run) without a
/// place.
void check_record(const RunRecord& record);

}  // namespace freshet
