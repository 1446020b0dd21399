// SPDX-License-Identifier: MIT
/// How a step follows from the rates. A fluid's evolve(i, f) calls f(value, rate, memory) for each
/// quantity that has a rate: v with a, and the density where it is advanced in time.
#pragma once
#include <cstdint>

#include "boundary/confinement.h"
#include "core/field.h"
#include "freshet/time_step.h"

namespace freshet {
inline namespace FRESHET_ISA {

/// One step of time [s].
struct Tick {
  Real dt;
  std::int64_t step;  ///< counted from 0
};

/// q += dt q'
struct Kick {
  Real dt;
  template <class T> FRESHET_HD void operator()(int i, Field<T> q, Field<T> rate, Field<T>) const {
    q[i] += dt * rate[i];
  }
};
/// memory = q + dt q'
struct HalfKick {
  Real dt;
  template <class T>
  FRESHET_HD void operator()(int i, Field<T> q, Field<T> rate, Field<T> m) const {
    m[i] = q[i] + dt * rate[i];
  }
};
/// q = memory + dt q': with the old rate a prediction, with the new one the second half kick
struct SecondKick {
  Real dt;
  template <class T>
  FRESHET_HD void operator()(int i, Field<T> q, Field<T> rate, Field<T> m) const {
    q[i] = m[i] + dt * rate[i];
  }
};
/// memory = q, q += dt q': a prediction by the rate before
struct Predict {
  Real dt;
  template <class T>
  FRESHET_HD void operator()(int i, Field<T> q, Field<T> rate, Field<T> m) const {
    m[i] = q[i];
    q[i] += dt * rate[i];
  }
};

/// v_(n+1) = v_n + dt a_n, x_(n+1) = x_n + dt v_(n+1): first order, one force a step.
template <class Fluid, class Confinement> struct EulerStep {
  Fluid f;
  Confinement confine;
  Real dt;
  FRESHET_HD void operator()(int i) const {
    f.evolve(i, Kick{dt});
    f.x[i] += dt * f.v[i];
    confine(i, f, f.v[i]);
  }
};

/// Leapfrog in its kick-drift-kick form, first half: second order. Viscosity needs v at the end of
/// the step before it is known; the old rate predicts it.
template <class Fluid, class Confinement> struct KickDrift {
  Fluid f;
  Confinement confine;
  Real dt;
  FRESHET_HD void operator()(int i) const {
    f.evolve(i, HalfKick{dt / 2});
    f.x[i] += dt * f.v_memory[i];
    confine(i, f, f.v_memory[i]);
    f.evolve(i, SecondKick{dt / 2});
  }
};
template <class Fluid> struct LastKick {
  Fluid f;
  Real dt;
  FRESHET_HD void operator()(int i) const { f.evolve(i, SecondKick{dt / 2}); }
};

/// Verlet in its position form, drift-kick-drift: second order, one force a step, in its middle
/// [Tuckerman, Berne, Martyna 1992]. What the force needs there beside x, the rate before predicts.
template <class Fluid, class Confinement> struct HalfDrift {
  Fluid f;
  Confinement confine;
  Real dt;
  FRESHET_HD void operator()(int i) const {
    f.x[i] += dt / 2 * f.v[i];
    confine(i, f, f.v[i]);
    f.evolve(i, Predict{dt / 2});
  }
};
template <class Fluid, class Confinement> struct KickHalfDrift {
  Fluid f;
  Confinement confine;
  Real dt;
  FRESHET_HD void operator()(int i) const {
    f.evolve(i, SecondKick{dt});
    f.x[i] += dt / 2 * f.v[i];
    confine(i, f, f.v[i]);
  }
};

/// One step: rates() fills a (and the rates of what else evolves) at the present x and v.
template <class B, class Fluid, class C, class Rates>
void integrate(B& backend, Integrator integrator, const Fluid& f, const C& confine, const Tick& t,
               const Rates& rates) {
  switch (integrator) {
    case Integrator::symplectic_euler:
      rates();
      backend.for_each("kick, drift", f, EulerStep<Fluid, C>{f, confine, t.dt});
      break;
    case Integrator::leapfrog:
      if (t.step == 0) rates();
      backend.for_each("kick, drift", f, KickDrift<Fluid, C>{f, confine, t.dt});
      rates();
      backend.for_each("kick", f, LastKick<Fluid>{f, t.dt});
      break;
    case Integrator::verlet:
      backend.for_each("drift", f, HalfDrift<Fluid, C>{f, confine, t.dt});
      rates();
      backend.for_each("kick, drift", f, KickHalfDrift<Fluid, C>{f, confine, t.dt});
      break;
  }
}

}  // namespace FRESHET_ISA
}  // namespace freshet
