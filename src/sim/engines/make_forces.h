// SPDX-License-Identifier: MIT
#pragma once
#include <memory>

#include "sim/engine.h"
#include "solvers/non_pressure_forces.h"

namespace freshet {
inline namespace FRESHET_ISA {

/// What a scene asks for beside pressure; null if nothing. Defined for each backend and dimension
/// in a file of its own, which is made from forces.cpp.in.
template <int D, class Backend>
std::unique_ptr<NonPressureForces<D, Backend>> make_forces(const EngineInput&);

}  // namespace FRESHET_ISA
}  // namespace freshet
