// SPDX-License-Identifier: MIT
#pragma once

namespace freshet {

/// The type of every particle field: float, or double where the library was configured with
/// -DFRESHET_DOUBLE=ON (the one build option that changes physics).
#ifdef FRESHET_DOUBLE
using Real = double;
#else
using Real = float;
#endif

}  // namespace freshet
