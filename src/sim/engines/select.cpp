// SPDX-License-Identifier: MIT
#include "sim/engines/select.h"

#include <fmt/format.h>

#include <thread>

#include "sim/engines/cpu.h"

namespace freshet {
namespace {

struct InstructionSet {
  const char* name;
  bool supported;
  MakeCpuEngine* mueller2003_2d;
};

/// Best first.
std::vector<InstructionSet> instruction_sets() {
#if defined(__x86_64__) && !defined(FRESHET_DOUBLE)
  __builtin_cpu_init();
  const auto has = [](auto... supported) { return (supported && ...); };
  const bool sse42 = __builtin_cpu_supports("sse4.2"), avx2 = __builtin_cpu_supports("avx2");
  const bool avx512 = has(__builtin_cpu_supports("avx512f"), __builtin_cpu_supports("avx512bw"),
                          __builtin_cpu_supports("avx512cd"), __builtin_cpu_supports("avx512dq"),
                          __builtin_cpu_supports("avx512vl"));
  return {{"avx512", avx512, make_cpu_avx512_mueller2003_2d},
          {"avx2", avx2, make_cpu_avx2_mueller2003_2d},
          {"sse42", sse42, make_cpu_sse42_mueller2003_2d},
          {"plain", true, make_cpu_base_mueller2003_2d}};
#else
  return {{"plain", true, make_cpu_base_mueller2003_2d}};
#endif
}

InstructionSet choose(const std::string& isa) {
  std::string supported;
  for (const InstructionSet& set : instruction_sets()) {
    if (set.supported && (isa.empty() || isa == set.name)) return set;
    if (set.supported) supported += (supported.empty() ? "" : ", ") + std::string(set.name);
  }
  throw Error(Error::Kind::scene, "--isa " + isa,
              fmt::format("this machine (or this build) does not have it; it has {}", supported));
}

}  // namespace

std::string instruction_set(const std::string& isa) { return choose(isa).name; }

int thread_count(int threads) {
  return threads > 0 ? threads : std::max(1, int(std::thread::hardware_concurrency()));
}

std::unique_ptr<Engine> make_engine(const Scene& scene, const Derived& derived,
                                    const Execution& execution) {
  const Sample start = sample(scene);
  if (scene.solver.backend == BackendName::reference)
    return make_reference_mueller2003_2d(scene, derived, start);
  return choose(execution.isa)
      .mueller2003_2d(scene, derived, start, thread_count(execution.threads));
}

}  // namespace freshet
