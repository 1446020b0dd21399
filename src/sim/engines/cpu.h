// SPDX-License-Identifier: MIT
/// The engines of the cpu backend, one of each for every instruction set: the files cpu_*.cpp are
/// compiled once a set, with FRESHET_ISA as its name.
#pragma once
#include "sim/engine.h"

#define FRESHET_JOIN_NAMES(a, b) make_cpu_##a##_##b
#define FRESHET_EXPAND_NAMES(a, b) FRESHET_JOIN_NAMES(a, b)
/// make_cpu_ISA_NAME of the instruction set that is being compiled.
#define FRESHET_CPU_ENGINE(name) FRESHET_EXPAND_NAMES(FRESHET_ISA, name)

namespace freshet {

using MakeCpuEngine = std::unique_ptr<Engine>(const Scene&, const Derived&, const Sample&,
                                              int threads);
#define FRESHET_CPU_ENGINES(isa) MakeCpuEngine make_cpu_##isa##_mueller2003_2d;
FRESHET_CPU_ENGINES(base)
FRESHET_CPU_ENGINES(sse42)
FRESHET_CPU_ENGINES(avx2)
FRESHET_CPU_ENGINES(avx512)
#undef FRESHET_CPU_ENGINES

}  // namespace freshet
