// SPDX-License-Identifier: MIT
/// Macros and functions that let g++, clang and nvcc compile one source for every instruction set.
#pragma once
#include <cmath>

#include "freshet/real.h"

#if defined(__CUDACC__)
#define FRESHET_HD __host__ __device__ __forceinline__
#define FRESHET_LAMBDA __host__ __device__
#else
#define FRESHET_HD inline __attribute__((always_inline))
#define FRESHET_LAMBDA
#endif

// Every translation unit names the instruction set that it is compiled for. The name is an inline
// namespace, so that no inline function is shared between objects of different instruction sets.
#ifndef FRESHET_ISA
#define FRESHET_ISA base
#endif

namespace freshet {
inline namespace FRESHET_ISA {

constexpr Real pi = Real(3.14159265358979323846);

/// m ? a : b without a branch. SIMD packs overload it lane by lane.
FRESHET_HD float select(bool m, float a, float b) { return m ? a : b; }
FRESHET_HD double select(bool m, double a, double b) { return m ? a : b; }
FRESHET_HD float sqrt(float a) { return ::sqrtf(a); }
FRESHET_HD double sqrt(double a) { return ::sqrt(a); }
FRESHET_HD float max(float a, float b) { return a > b ? a : b; }
FRESHET_HD double max(double a, double b) { return a > b ? a : b; }
FRESHET_HD float min(float a, float b) { return a < b ? a : b; }
FRESHET_HD double min(double a, double b) { return a < b ? a : b; }
template <class R> FRESHET_HD R square(R a) { return a * a; }

}  // namespace FRESHET_ISA
}  // namespace freshet
