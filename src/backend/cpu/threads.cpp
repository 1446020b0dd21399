// SPDX-License-Identifier: MIT
#include "backend/cpu/threads.h"

#ifdef _OPENMP
#include <omp.h>

#include <latch>
#include <string>
#include <system_error>
#include <thread>
#include <vector>
#endif

#include <atomic>
#include <exception>

#include "freshet/error.h"

namespace freshet {
namespace {

#ifdef _OPENMP

/// Starts and ends so many threads. libgomp ends the process where it cannot start one; this
/// throws.
void try_threads(int count) {
  std::latch all_started(1);
  std::vector<std::jthread> threads;
  try {
    threads.reserve(std::size_t(count));
    for (int k = 0; k < count; ++k) threads.emplace_back([&] { all_started.wait(); });
  } catch (const std::system_error& e) {
    const std::size_t started = threads.size() + 1;
    all_started.count_down();
    throw Error(Error::Kind::run, "option threads " + std::to_string(count + 1),
                "the system starts " + std::to_string(started) + " of them (" + e.code().message() +
                    "); use fewer `threads`, or raise the limit on processes (ulimit -u) or "
                    "memory (ulimit -v)",
                {"threads"});
  } catch (...) {
    all_started.count_down();
    throw;
  }
  all_started.count_down();
}

/// Makes OpenMP start its threads now, on the memory that try_threads has just given back. Later
/// the run could have taken that memory.
[[gnu::noinline]] void start_team(int count) {
  std::atomic<int> started{0};
#pragma omp parallel num_threads(count)
  ++started;
}

#endif

}  // namespace

Threads::Threads(int count) : count_(count) {
  static std::atomic<int> most{1};  // that were started so far: OpenMP keeps them
  if (count <= most) return;
#ifdef _OPENMP
  try_threads(count - 1);
  start_team(count);
#endif
  most = count;
}

int Threads::current() {
#ifdef _OPENMP
  return omp_get_thread_num();
#else
  return 0;
#endif
}

void Threads::run(int parts, const void* context, void (*part)(const void*, int)) const {
  // Without OpenMP: libgomp allocates memory where the number of threads changes, and ends the
  // process if the allocation fails. libomp writes a file when it starts.
  if (parts > 1 && count_ > 1) return run_together(parts, context, part);
  for (int k = 0; k < parts; ++k) part(context, k);
}

// Not inlined: clang calls OpenMP at the start of a function that has a parallel loop.
[[gnu::noinline]] void Threads::run_together(int parts, const void* context,
                                             void (*part)(const void*, int)) const {
  std::exception_ptr error;
  std::atomic<bool> failed{false};
#ifdef _OPENMP
#pragma omp parallel for num_threads(count_) schedule(dynamic, 1)
#endif
  for (int k = 0; k < parts; ++k) {
    if (failed.load(std::memory_order_relaxed)) continue;
    try {
      part(context, k);
    } catch (...) {  // an exception must not leave the loop
#ifdef _OPENMP
#pragma omp critical(freshet_error)
#endif
      error = std::current_exception();
      failed = true;
    }
  }
  if (error) std::rethrow_exception(error);
}

}  // namespace freshet
