// SPDX-License-Identifier: MIT
#include "sim/engines/select.h"

#include <fmt/format.h>

#include <algorithm>
#include <thread>

#include "core/portable.h"
#include "scene/keys.h"

namespace freshet {
inline namespace FRESHET_ISA {
template <SolverName, int> std::unique_ptr<Engine> make_reference_engine(const EngineInput&);
}

/// The engines of a backend, by solver.
struct Makers {
  std::vector<MakeEngine*> flat, deep;  ///< in 2D, in 3D
};

// src/CMakeLists.txt says which instruction sets are compiled: FRESHET_CPU_ENGINES calls
// FRESHET_CPU_ENGINE(isa) for each, the best first.
#define FRESHET_CPU_ENGINE(isa)                                                           \
  namespace isa {                                                                         \
  template <SolverName, int> std::unique_ptr<Engine> make_cpu_engine(const EngineInput&); \
  template <int... solver> Makers cpu_makers(std::integer_sequence<int, solver...>) {     \
    return {{make_cpu_engine<SolverName(solver), 2>...},                                  \
            {make_cpu_engine<SolverName(solver), 3>...}};                                 \
  }                                                                                       \
  }
FRESHET_CPU_ENGINES
#undef FRESHET_CPU_ENGINE

namespace {

using Solvers = std::make_integer_sequence<int, std::size(solver_words)>;

template <int... solver> Makers reference_makers(std::integer_sequence<int, solver...>) {
  return {{make_reference_engine<SolverName(solver), 2>...},
          {make_reference_engine<SolverName(solver), 3>...}};
}

struct InstructionSet {
  std::string name;
  Makers makers;
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
#define FRESHET_CPU_ENGINE(isa) {#isa, isa::cpu_makers(Solvers{})},
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
  const Makers makers = scene.solver.backend == BackendName::reference
                            ? reference_makers(Solvers{})
                            : choose(execution.isa).makers;
  const auto& of_dimension = scene.dimension() == 2 ? makers.flat : makers.deep;
  return of_dimension[std::size_t(scene.solver.name)](input);
}

}  // namespace freshet
