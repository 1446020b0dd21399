// SPDX-License-Identifier: MIT
#include "sim/engines/select.h"

#include <fmt/format.h>

#include <algorithm>
#include <thread>

#include "core/portable.h"

namespace freshet {

// src/CMakeLists.txt says which instruction sets are compiled: FRESHET_CPU_ENGINES calls
// FRESHET_CPU_ENGINE(isa) for each, the best first.
#define FRESHET_CPU_ENGINE(isa)  \
  namespace isa {                \
  MakeEngine make_cpu_engine_2d; \
  MakeEngine make_cpu_engine_3d; \
  }
FRESHET_CPU_ENGINES
#undef FRESHET_CPU_ENGINE
inline namespace FRESHET_ISA {
MakeEngine make_reference_engine_2d;
MakeEngine make_reference_engine_3d;
}  // namespace FRESHET_ISA

namespace {

struct InstructionSet {
  std::string name;
  MakeEngine *make_2d, *make_3d;
};

bool supported(const std::string& name) {
  if (name == "plain") return true;
#if defined(__x86_64__)
  __builtin_cpu_init();
  if (name == "sse42") return __builtin_cpu_supports("sse4.2");
  if (name == "avx2") return __builtin_cpu_supports("avx2");
  return __builtin_cpu_supports("avx512f") && __builtin_cpu_supports("avx512bw") &&
         __builtin_cpu_supports("avx512cd") && __builtin_cpu_supports("avx512dq") &&
         __builtin_cpu_supports("avx512vl");
#else
  return false;
#endif
}

/// Those that were compiled and that this machine has, best first.
std::vector<InstructionSet> instruction_sets() {
  std::vector<InstructionSet> all{
#define FRESHET_CPU_ENGINE(isa) {#isa, isa::make_cpu_engine_2d, isa::make_cpu_engine_3d},
      FRESHET_CPU_ENGINES
#undef FRESHET_CPU_ENGINE
  };
  for (InstructionSet& set : all)
    if (set.name == "base") set.name = "plain";
  std::erase_if(all, [](const InstructionSet& set) { return !supported(set.name); });
  return all;
}

InstructionSet choose(const std::string& isa) {
  std::string names;
  for (const InstructionSet& set : instruction_sets()) {
    if (isa.empty() || isa == set.name) return set;
    names += (names.empty() ? "" : ", ") + set.name;
  }
  throw Error(Error::Kind::scene, isa.empty() ? "--backend cpu" : "--isa " + isa,
              names.empty() ? "this machine has no instruction set that was compiled; take the "
                              "reference backend"
                            : fmt::format("this machine (or this build) does not have it; it has "
                                          "{}",
                                          names));
}

}  // namespace

std::string instruction_set(const std::string& isa) { return choose(isa).name; }

int thread_count(int threads) {
  return threads > 0 ? threads : std::max(1, int(std::thread::hardware_concurrency()));
}

std::unique_ptr<Engine> make_engine(const Scene& scene, const Derived& derived,
                                    const Execution& execution) {
  const Sample start = sample(scene);
  const EngineInput input{scene, derived, start, thread_count(execution.threads)};
  const bool flat = scene.dimension() == 2;
  if (scene.solver.backend == BackendName::reference)
    return flat ? make_reference_engine_2d(input) : make_reference_engine_3d(input);
  const InstructionSet set = choose(execution.isa);
  return flat ? set.make_2d(input) : set.make_3d(input);
}

}  // namespace freshet
