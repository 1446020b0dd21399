// SPDX-License-Identifier: MIT
#include "idle_threads.h"

#include <unistd.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <iterator>
#include <string_view>

namespace freshet::cli {

void let_idle_threads_sleep(int argc, char** argv) {
  constexpr std::string_view computes[] = {"run",    "resume",  "info",    "bench",
                                           "render", "measure", "validate"};
  constexpr const char* spins = "2000";  // about 10 microseconds; the default is a millisecond
  if (argc < 2 || std::getenv("OMP_WAIT_POLICY") || std::getenv("GOMP_SPINCOUNT") ||
      std::find(std::begin(computes), std::end(computes), argv[1]) == std::end(computes))
    return;
  std::error_code ec;
  const std::filesystem::path self = std::filesystem::read_symlink("/proc/self/exe", ec);
  if (!ec && setenv("GOMP_SPINCOUNT", spins, 1) == 0) execv(self.c_str(), argv);
}

}  // namespace freshet::cli
