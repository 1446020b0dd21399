// SPDX-License-Identifier: MIT
/// A solver on a backend in one dimension, with the kernel that the scene asks for. Each fast
/// kernel is compiled for itself; the others share one. Solvers that solve for the pressure, which
/// are slow to compile, have one fast kernel, the cubic spline.
#pragma once
#include "kernels/cubic_spline.h"
#include "kernels/wendland.h"
#include "kernels/wendland_smooth.h"
#include "sim/engine_of.h"
#include "sim/parameters.h"

namespace freshet {
inline namespace FRESHET_ISA {

// The file that includes this one has included the solver that it is for.
template <int D, Backend<D> B> struct Mueller2003;
template <int D, Backend<D> B, template <int> class Kernel> struct Wcsph;
template <int D, Backend<D> B, template <int> class Kernel> struct DeltaSph;
template <int D, Backend<D> B, template <int> class Kernel> struct Pcisph;
template <int D, Backend<D> B, template <int> class Kernel> struct Iisph;
template <int D, Backend<D> B, template <int> class Kernel> struct Dfsph;
template <int D, Backend<D> B, template <int> class Kernel> struct Pbf;

// Each combination is defined in a file of its own, which is made from engine.cpp.in.
template <SolverName solver, int D> std::unique_ptr<Engine> make_cpu_engine(const EngineInput&);
template <SolverName solver, int D>
std::unique_ptr<Engine> make_reference_engine(const EngineInput&);

template <class Backend> Backend make_backend(const EngineInput& in) {
  if constexpr (std::is_constructible_v<Backend, int>) return Backend(in.threads);
  else return Backend(in.scene.solver.search, in.scene.solver.neighbor_order);
}

/// f(kernel) for the scene's.
template <int D, bool fast_c2, class F> auto with_kernel(const Scene& s, Real support, const F& f) {
  switch (s.solver.kernel) {
    case KernelName::cubic_spline:
      return f(CubicSpline<D>(support));
    case KernelName::wendland_c2:
      if constexpr (fast_c2) return f(WendlandC2<D>(support));
      else return f(WendlandSmooth<D>(support, 2));
    case KernelName::wendland_c4:
      return f(WendlandSmooth<D>(support, 4));
    case KernelName::wendland_c6:
      break;
  }
  return f(WendlandSmooth<D>(support, 6));
}

template <SolverName solver, int D, class B, template <int> class Kernel>
auto solver_of(const EngineInput& in, const Kernel<D>& W) {
  if constexpr (solver >= SolverName::pcisph) {
    const auto c = incompressible_parameters<D>(in.scene, in.derived, W);
    if constexpr (solver == SolverName::pcisph) return Pcisph<D, B, Kernel>{{c, W}};
    else if constexpr (solver == SolverName::iisph) return Iisph<D, B, Kernel>{{c, W}};
    else if constexpr (solver == SolverName::dfsph) return Dfsph<D, B, Kernel>{{c, W}};
    else return Pbf<D, B, Kernel>{{c, W}};
  } else {
    const auto c = weakly_compressible_parameters<D>(in.scene, in.derived);
    if constexpr (solver == SolverName::wcsph) return Wcsph<D, B, Kernel>{c, W};
    else
      return DeltaSph<D, B, Kernel>{c, W,
                                    in.scene.density_diffusion() == DensityDiffusion::antuono2010};
  }
}

template <SolverName solver, int D, class Backend>
std::unique_ptr<Engine> make_engine_on(Backend backend, const EngineInput& in) {
  const auto engine_of = [&](auto s) -> std::unique_ptr<Engine> {
    return std::make_unique<EngineOf<D, decltype(s), Backend>>(std::move(backend), std::move(s),
                                                               in);
  };
  if constexpr (solver == SolverName::mueller2003)
    return engine_of(Mueller2003<D, Backend>{mueller2003_parameters<D>(in.scene, in.derived)});
  else
    return with_kernel < D,
           solver<SolverName::pcisph>(
               in.scene, Real(in.derived.support_radius),
               [&](const auto& W) { return engine_of(solver_of<solver, D, Backend>(in, W)); });
}

}  // namespace FRESHET_ISA
}  // namespace freshet
