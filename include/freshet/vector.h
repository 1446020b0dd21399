// SPDX-License-Identifier: MIT
#pragma once
#include <cstdint>
#include <vector>

namespace freshet {

using Vector = std::vector<double>;        ///< one number per dimension
using Counts = std::vector<std::int64_t>;  ///< one integer per dimension

}  // namespace freshet
