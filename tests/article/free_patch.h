// SPDX-License-Identifier: MIT
#pragma once
#include "solvers/patch.h"

namespace freshet {

using FreePatch = Patch<2, Mueller2003<2, ReferenceBackend<2>>>;

}  // namespace freshet
