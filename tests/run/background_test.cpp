// SPDX-License-Identifier: MIT
#include "run/background.h"

#include <gtest/gtest.h>

#include <atomic>
#include <chrono>
#include <future>
#include <stdexcept>
#include <vector>

namespace freshet {
namespace {

using namespace std::chrono_literals;

TEST(Background, RunsJobsInOrder) {
  std::vector<int> done;
  Background background(2);
  for (int k = 0; k < 100; ++k) background.add([&done, k] { done.push_back(k); });
  background.wait();
  ASSERT_EQ(100u, done.size());
  for (int k = 0; k < 100; ++k) EXPECT_EQ(k, done[std::size_t(k)]);
}

TEST(Background, LimitsTheNumberOfWaitingJobs) {
  std::promise<void> go;
  std::shared_future<void> gate = go.get_future().share();
  std::atomic<int> added{0};
  Background background(2);
  auto adding = std::async(std::launch::async, [&] {
    for (int k = 0; k < 5; ++k) {
      background.add([gate] { gate.wait(); });
      ++added;
    }
  });
  while (added < 3) std::this_thread::sleep_for(1ms);
  EXPECT_EQ(std::future_status::timeout, adding.wait_for(50ms));
  EXPECT_EQ(3, added);  // one runs, two wait
  go.set_value();
  adding.get();
  background.wait();
  EXPECT_EQ(5, added);
}

TEST(Background, RethrowsTheExceptionOfAJob) {
  bool later = false;
  Background background(2);
  background.add([] { throw std::runtime_error("full"); });
  EXPECT_THROW(background.wait(), std::runtime_error);
  EXPECT_THROW(background.add([&] { later = true; }), std::runtime_error);
  EXPECT_THROW(background.wait(), std::runtime_error);
  EXPECT_FALSE(later);
}

TEST(Background, DropsWaitingJobsWhenDestroyed) {
  std::promise<void> go;
  std::shared_future<void> gate = go.get_future().share();
  std::atomic<bool> dropped{true};
  std::future<void> opener;
  {
    Background background(2);
    background.add([gate] { gate.wait(); });
    background.add([&] { dropped = false; });
    opener = std::async(std::launch::async, [&] {
      std::this_thread::sleep_for(50ms);
      go.set_value();
    });
  }
  EXPECT_TRUE(dropped);
}

}  // namespace
}  // namespace freshet
