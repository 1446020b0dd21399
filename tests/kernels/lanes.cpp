// SPDX-License-Identifier: MIT
#include "kernels/lanes.h"

namespace freshet {
inline namespace FRESHET_ISA {

void evaluate_in_packs(const Real* const (&x)[3], int n, Real* out) {
  evaluate_all<Pack>(x, n, out);
}

}  // namespace FRESHET_ISA
}  // namespace freshet
