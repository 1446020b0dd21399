// SPDX-License-Identifier: MIT
#include "backend/reference/reference_sets_impl.h"

namespace freshet {
inline namespace FRESHET_ISA {

template class ReferenceSets<2>;
template class ReferenceSets<3>;

}  // namespace FRESHET_ISA
}  // namespace freshet
