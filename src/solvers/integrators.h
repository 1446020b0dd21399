// SPDX-License-Identifier: MIT
/// Time integrators. A fluid's evolve(i, f) calls f(i, value, rate, memory) for each quantity that
/// has a rate: v with the rate a, and the density of delta-SPH with drho.
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
/// memory = q, q += dt q': a prediction with the previous rate
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
    const auto from = f.x[i];
    f.x[i] += dt * f.v[i];
    confine(i, f, f.v[i], from);
  }
};

/// The first half of leapfrog in its kick-drift-kick form: second order. Viscosity needs v at the
/// end of the step, which the old rate predicts.
template <class Fluid, class Confinement> struct KickDrift {
  Fluid f;
  Confinement confine;
  Real dt;
  FRESHET_HD void operator()(int i) const {
    f.evolve(i, HalfKick{dt / 2});
    const auto from = f.x[i];
    f.x[i] += dt * f.v_memory[i];
    confine(i, f, f.v_memory[i], from);
    f.evolve(i, SecondKick{dt / 2});
  }
};
/// The second half of leapfrog: the kick with the new rate.
template <class Fluid> struct LastKick {
  Fluid f;
  Real dt;
  FRESHET_HD void operator()(int i) const { f.evolve(i, SecondKick{dt / 2}); }
};

/// The first half of Verlet in its position form, drift-kick-drift [Tuckerman, Berne, Martyna
/// 1992]. It is of second order with one force a step, at the middle of the step. Quantities other
/// than x that the force needs there are predicted with the previous rate.
template <class Fluid, class Confinement> struct HalfDrift {
  Fluid f;
  Confinement confine;
  Real dt;
  FRESHET_HD void operator()(int i) const {
    const auto from = f.x[i];
    f.x[i] += dt / 2 * f.v[i];
    confine(i, f, f.v[i], from);
    f.evolve(i, Predict{dt / 2});
  }
};
/// The second half of Verlet: the kick of the whole step, then the second half drift.
template <class Fluid, class Confinement> struct KickHalfDrift {
  Fluid f;
  Confinement confine;
  Real dt;
  FRESHET_HD void operator()(int i) const {
    f.evolve(i, SecondKick{dt});
    const auto from = f.x[i];
    f.x[i] += dt / 2 * f.v[i];
    confine(i, f, f.v[i], from);
  }
};

/// Takes one step. rates() computes a, and the rates of other quantities that evolve, at the
/// present x and v.
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
