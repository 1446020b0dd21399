// SPDX-License-Identifier: MIT
// The solvers, and with them pair terms, kernels, walls and integrators, as device code: proof that
// their one source serves a GPU. Nothing launches this yet.
#include "backend/cuda/all_pairs_backend.cuh"
#include "kernels/cubic_spline.h"
#include "kernels/wendland.h"
#include "kernels/wendland_smooth.h"
#include "solvers/delta_sph.h"
#include "solvers/mueller2003.h"
#include "solvers/wcsph.h"

namespace freshet {
inline namespace FRESHET_ISA {

template <int D> using Device = AllPairsBackend<D>;

template struct Mueller2003<2, Device<2>>;
template struct Mueller2003<3, Device<3>>;
template struct Wcsph<2, Device<2>, CubicSpline>;
template struct Wcsph<3, Device<3>, CubicSpline>;
template struct Wcsph<3, Device<3>, WendlandC2>;
template struct Wcsph<3, Device<3>, WendlandSmooth>;
template struct DeltaSph<2, Device<2>, WendlandC4>;
template struct DeltaSph<3, Device<3>, WendlandC2>;
template struct DeltaSph<3, Device<3>, WendlandC6>;

}  // namespace FRESHET_ISA
}  // namespace freshet
