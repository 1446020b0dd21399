// SPDX-License-Identifier: MIT
// Compiles the solvers, and with them pair terms, kernels, walls and integrators, as device code.
// It proves that one source serves CPU and GPU. Nothing launches this yet.
#include "backend/cuda/all_pairs_backend.cuh"
#include "kernels/cubic_spline.h"
#include "kernels/wendland.h"
#include "kernels/wendland_smooth.h"
#include "solvers/delta_sph.h"
#include "solvers/dfsph.h"
#include "solvers/iisph.h"
#include "solvers/incompressible_impl.h"
#include "solvers/mueller2003.h"
#include "solvers/pbf.h"
#include "solvers/pcisph.h"
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
template struct Incompressible<2, Device<2>, CubicSpline>;
template struct Incompressible<2, Device<2>, WendlandSmooth>;
template struct Incompressible<3, Device<3>, CubicSpline>;
template struct Incompressible<3, Device<3>, WendlandSmooth>;
template struct Pcisph<2, Device<2>, CubicSpline>;
template struct Iisph<3, Device<3>, WendlandSmooth>;
template struct Dfsph<2, Device<2>, WendlandSmooth>;
template struct Dfsph<3, Device<3>, CubicSpline>;
template struct Pbf<3, Device<3>, CubicSpline>;

}  // namespace FRESHET_ISA
}  // namespace freshet
