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

/// The engines of a backend, by solver; null where one was not compiled.
struct Makers {
  MakeEngine* flat[std::size(solver_words)] = {};  ///< in 2D
  MakeEngine* deep[std::size(solver_words)] = {};  ///< in 3D
};

// src/CMakeLists.txt says what is compiled: FRESHET_CPU_ENGINES calls FRESHET_CPU_ENGINE(isa) for
// each instruction set, the best first, and FRESHET_SOLVERS calls FRESHET_SOLVER(name) for each
// solver.
#define FRESHET_SOLVER(name)                                                     \
  makers.flat[int(SolverName::name)] = FRESHET_MAKE_ENGINE<SolverName::name, 2>; \
  makers.deep[int(SolverName::name)] = FRESHET_MAKE_ENGINE<SolverName::name, 3>;
#define FRESHET_MAKE_ENGINE make_cpu_engine
#define FRESHET_CPU_ENGINE(isa)                                                           \
  namespace isa {                                                                         \
  template <SolverName, int> std::unique_ptr<Engine> make_cpu_engine(const EngineInput&); \
  static Makers cpu_makers() {                                                            \
    Makers makers;                                                                        \
    FRESHET_SOLVERS                                                                       \
    return makers;                                                                        \
  }                                                                                       \
  }
FRESHET_CPU_ENGINES
#undef FRESHET_CPU_ENGINE
#undef FRESHET_MAKE_ENGINE

namespace {

#define FRESHET_MAKE_ENGINE make_reference_engine
Makers reference_makers() {
  Makers makers;
  FRESHET_SOLVERS
  return makers;
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
#define FRESHET_CPU_ENGINE(isa) {#isa, isa::cpu_makers()},
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
                            ? reference_makers()
                            : choose(execution.isa).makers;
  const int solver = int(scene.solver.name);
  MakeEngine* const make = scene.dimension() == 2 ? makers.flat[solver] : makers.deep[solver];
  if (!make)
    throw Error(Error::Kind::scene, "solver.name",
                fmt::format("this build has no {}; compile with it in FRESHET_SOLVERS",
                            solver_words[solver]));
  return make(input);
}

bool has_solver(SolverName name) { return reference_makers().flat[int(name)] != nullptr; }

}  // namespace freshet
