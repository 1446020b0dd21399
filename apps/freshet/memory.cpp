// SPDX-License-Identifier: MIT
#include "memory.h"

#include <sys/mman.h>

#include <atomic>
#include <cstddef>
#include <new>

namespace freshet::cli {
namespace {

constexpr std::size_t reserve_bytes = 32
                                      << 20;  // address space: pages that are not written are free
std::atomic<void*> reserve{nullptr};
std::atomic<bool> ran_short{false};

/// The new-handler: operator new tries again after it returns.
void use_reserve() {
  ran_short = true;
  void* bytes = reserve.exchange(nullptr);
  if (!bytes) throw std::bad_alloc();
  munmap(bytes, reserve_bytes);
}

/// The stack of the main thread grows on demand, and the process is killed where it cannot.
void grow_stack() {
  constexpr std::size_t bytes = 256 << 10, page = 4096;
  volatile char stack[bytes];
  for (std::size_t at = 0; at < bytes; at += page) stack[at] = 0;
  static_cast<void>(stack[0]);
}

}  // namespace

void keep_memory_in_reserve() {
  grow_stack();
  void* bytes = mmap(nullptr, reserve_bytes, PROT_READ | PROT_WRITE,
                     MAP_PRIVATE | MAP_ANONYMOUS | MAP_NORESERVE, -1, 0);
  reserve = bytes == MAP_FAILED ? nullptr : bytes;
  std::set_new_handler(use_reserve);
}

bool memory_ran_short() { return ran_short; }

}  // namespace freshet::cli
