// SPDX-License-Identifier: MIT
#include "engine/select.h"

#include <fmt/format.h>

#include <algorithm>
#include <thread>

#include "core/portable.h"
#include "freshet/error.h"

namespace freshet {
inline namespace FRESHET_ISA {
template <int D> std::unique_ptr<Engine> make_reference_engine(const EnginePlan& plan);
}

/// The engines of a backend in 2D and 3D; null where they are not compiled.
struct Makers {
  MakeEngine *flat, *deep;
};

// FRESHET_FLAT: no engine in 3D is linked (web/CMakeLists.txt). FRESHET_REFERENCE_FLAT: none of the
// reference backend.
#ifdef FRESHET_FLAT
#define FRESHET_DEEP(make) nullptr
#else
#define FRESHET_DEEP(make) make<3>
#endif

// src/CMakeLists.txt defines the lists: FRESHET_CPU_ENGINES calls FRESHET_CPU_ENGINE(isa)
// for each instruction set, the best first. FRESHET_SOLVERS and FRESHET_REFERENCE_SOLVERS call
// FRESHET_SOLVER(name) for each solver of the cpu and of the reference backend.
#define FRESHET_CPU_ENGINE(isa)                                                              \
  namespace isa {                                                                            \
  template <int D> std::unique_ptr<Engine> make_cpu_engine(const EnginePlan& plan);          \
  static Makers cpu_makers() { return {make_cpu_engine<2>, FRESHET_DEEP(make_cpu_engine)}; } \
  }
FRESHET_CPU_ENGINES
#undef FRESHET_CPU_ENGINE

namespace {

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
#elif defined(__EMSCRIPTEN__)
  return name == "sse42";  // by the SIMD instructions of WebAssembly
#else
  return false;
#endif
}

/// The instruction sets that are compiled and that this machine has, best first.
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
  throw Error(Error::Kind::scene, isa.empty() ? "option backend cpu" : "option isa " + isa,
              names.empty() ? "this machine has no instruction set that was compiled; take the "
                              "reference backend"
                            : fmt::format("this machine (or this build) does not have it; it has "
                                          "{}",
                                          names));
}

int hardware_threads() { return std::max(1, int(std::thread::hardware_concurrency())); }

Makers makers_of(const BackendChoice& choice) {
  if (choice.backend != BackendName::reference) return choose(choice.isa).makers;
#if defined(FRESHET_FLAT) || defined(FRESHET_REFERENCE_FLAT)
  return {make_reference_engine<2>, nullptr};
#else
  return {make_reference_engine<2>, make_reference_engine<3>};
#endif
}

#define FRESHET_SOLVER(name) SolverName::name,
constexpr SolverName compiled[] = {FRESHET_SOLVERS};
constexpr SolverName compiled_for_reference[] = {FRESHET_REFERENCE_SOLVERS};
#undef FRESHET_SOLVER

}  // namespace

std::string instruction_set(const std::string& isa) { return choose(isa).name; }

int thread_limit() { return std::max(64, 4 * hardware_threads()); }

int thread_count(int threads) {
  if (threads > thread_limit())
    throw Error(Error::Kind::scene, fmt::format("option threads {}", threads),
                fmt::format("at most {} on this machine, which runs {} at a time; use fewer, or "
                            "omit `threads` to use {}",
                            thread_limit(), hardware_threads(), hardware_threads()),
                {"threads"});
  return threads > 0 ? threads : hardware_threads();
}

int thread_count(int threads, double particles) {
  if (threads > 0) return thread_count(threads);
  constexpr double least = 2048;  // particles of a thread: docs/performance.md
  return std::max(1, int(std::min(double(hardware_threads()), particles / least)));
}

bool has_solver(SolverName name, BackendName backend, int dimension) {
  const auto is_in = [name](const auto& list) {
    return std::find(std::begin(list), std::end(list), name) != std::end(list);
  };
  const bool reference = backend == BackendName::reference;
  if (dimension == 3 && !makers_of({backend, ""}).deep) return false;
  return reference ? is_in(compiled_for_reference) : is_in(compiled);
}

std::unique_ptr<Engine> make_engine(const EnginePlan& plan, const BackendChoice& choice) {
  const Makers makers = makers_of(choice);
  return (plan.dimension == 2 ? makers.flat : makers.deep)(plan);
}

}  // namespace freshet
