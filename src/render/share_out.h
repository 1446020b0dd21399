// SPDX-License-Identifier: MIT
#pragma once
#include <atomic>
#include <future>
#include <system_error>
#include <vector>

namespace freshet {

/// Calls f(k) once for each k < n, on `threads` threads.
template <class F> void share_out(int n, int threads, F f) {
  std::atomic<int> next{0};
  const auto work = [&] {
    for (int k = next++; k < n; k = next++) f(k);
  };
  std::vector<std::future<void>> others;
  try {
    for (int t = 1; t < threads; ++t) others.push_back(std::async(std::launch::async, work));
  } catch (const std::system_error&) {  // no more can start: those that run do the work
  }
  work();
  for (auto& other : others) other.get();
}

}  // namespace freshet
