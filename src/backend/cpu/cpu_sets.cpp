// SPDX-License-Identifier: MIT
// Compiled once per instruction set.
#include "backend/cpu/cpu_sets_impl.h"

namespace freshet {
inline namespace FRESHET_ISA {

template class CpuSets<2>;
template class CpuSets<3>;

}  // namespace FRESHET_ISA
}  // namespace freshet
