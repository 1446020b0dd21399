// SPDX-License-Identifier: MIT
/// Every solver on one backend in one dimension. The two fast kernels are compiled each for itself;
/// the other Wendland kernels share one.
#pragma once
#include "kernels/cubic_spline.h"
#include "kernels/wendland.h"
#include "kernels/wendland_smooth.h"
#include "sim/engine_of.h"
#include "sim/parameters.h"

namespace freshet {
inline namespace FRESHET_ISA {

template <int D, template <int> class Kernel> Kernel<D> kernel_of(const Scene& s, Real support) {
  if constexpr (std::is_same_v<Kernel<D>, WendlandSmooth<D>>)
    return {support, s.solver.kernel == KernelName::wendland_c4 ? 4 : 6};
  else return Kernel<D>(support);
}

template <int D, class Backend>
std::unique_ptr<Engine> make_mueller2003(Backend backend, const EngineInput& input) {
  using Solver = Mueller2003<D, Backend>;
  return std::make_unique<EngineOf<D, Solver, Backend>>(
      std::move(backend), Solver{mueller2003_parameters<D>(input.scene, input.derived)}, input);
}

template <int D, template <int> class Kernel, class Backend>
std::unique_ptr<Engine> make_weakly_compressible(Backend backend, const EngineInput& input) {
  const auto c = weakly_compressible_parameters<D>(input.scene, input.derived);
  const auto W = kernel_of<D, Kernel>(input.scene, c.support);
  if (input.scene.solver.name == SolverName::wcsph) {
    using Solver = Wcsph<D, Backend, Kernel>;
    return std::make_unique<EngineOf<D, Solver, Backend>>(std::move(backend), Solver{c, W}, input);
  }
  using Solver = DeltaSph<D, Backend, Kernel>;
  const bool antuono = input.scene.solver.density_diffusion == DensityDiffusion::antuono2010;
  return std::make_unique<EngineOf<D, Solver, Backend>>(std::move(backend), Solver{c, W, antuono},
                                                        input);
}

template <int D, class Backend>
std::unique_ptr<Engine> make_engine_on(Backend backend, const EngineInput& input) {
  const auto& solver = input.scene.solver;
  if (solver.name == SolverName::mueller2003) return make_mueller2003<D>(std::move(backend), input);
  switch (solver.kernel) {
    case KernelName::cubic_spline:
      return make_weakly_compressible<D, CubicSpline>(std::move(backend), input);
    case KernelName::wendland_c2:
      return make_weakly_compressible<D, WendlandC2>(std::move(backend), input);
    case KernelName::wendland_c4:
    case KernelName::wendland_c6:
      break;
  }
  return make_weakly_compressible<D, WendlandSmooth>(std::move(backend), input);
}

}  // namespace FRESHET_ISA
}  // namespace freshet
