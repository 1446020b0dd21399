// SPDX-License-Identifier: MIT
/// Threads and buffers of the cpu backend where something fails.
#include "backend/cpu/threads.h"

#include <gtest/gtest.h>

#include <atomic>
#include <new>
#include <stdexcept>

#include "backend/cpu/buffer.h"
#include "cli/process.h"
#include "freshet/error.h"
#include "freshet/simulation.h"

namespace freshet::test {
namespace {

TEST(Threads, RethrowAnExceptionAndSkipTheRemainingParts) {
  for (const int count : {1, 2, 3}) {
    const Threads threads(count);
    std::atomic<int> done{0};
    EXPECT_THROW(threads.parts(100000,
                               [&](int part) {
                                 if (part == 0) throw std::bad_alloc();
                                 ++done;
                               }),
                 std::bad_alloc);
    EXPECT_LT(done, 99999);
    threads.parts(10, [&](int) { ++done; });  // they can be used again
  }
}

TEST(Threads, ExceptionOfASinglePartIsThrown) {
  const Threads threads(2);
  EXPECT_THROW(threads.parts(1, [](int) { throw std::runtime_error("one"); }), std::runtime_error);
}

TEST(Threads, CountIsLimited) {
  EXPECT_GE(thread_limit(), 64);
  EXPECT_EQ(thread_limit(), thread_count(thread_limit()));
  EXPECT_GE(thread_limit(), 4 * thread_count(0));
  try {
    thread_count(thread_limit() + 1);
    FAIL() << "no error";
  } catch (const Error& e) {
    EXPECT_EQ(Error::Kind::scene, e.kind());
    const Diagnostic& d = e.diagnostics().front();
    EXPECT_EQ("option threads " + std::to_string(thread_limit() + 1), d.place);
    EXPECT_NE(std::string::npos, d.message.find("at most " + std::to_string(thread_limit())));
  }
}

TEST(Buffer, IsEmptyAfterMemoryRanOut) {
  if (sanitized) GTEST_SKIP() << "the sanitizers end the process";
  Buffer<double> buffer;
  EXPECT_NE(nullptr, buffer.reserve(10));
  EXPECT_THROW(buffer.reserve(std::size_t(1) << 58), std::bad_alloc);
  EXPECT_EQ(0u, buffer.size());
  ASSERT_NE(nullptr, buffer.reserve(10));
  EXPECT_GE(buffer.size(), 10u);
}

}  // namespace
}  // namespace freshet::test
