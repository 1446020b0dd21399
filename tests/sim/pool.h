// SPDX-License-Identifier: MIT
/// Artificial particles under the health monitor.
#pragma once
#include <gtest/gtest.h>

#include <memory>
#include <numeric>
#include <string>
#include <vector>

#include "scene/model/setup.h"
#include "sim/health.h"

namespace freshet::test {

/// 10 × 10 particles of water in a box of 1 m without gravity; the speed of sound is 10 m/s. They
/// start at 20 m/s, so that speeds up to 20 m/s do not exceed the initial energy.
class Pool {
 public:
  explicit Pool(const std::string& more = "", const std::string& domain = "gravity = [0, 0]\n",
                const std::string& step = "step = 0.0005\n",
                const std::string& rest =
                    "velocity = [20, 0]\n[solver]\nname = \"wcsph\"\nsound_speed = 10\n")
      : scene_(with_defaults(parse_scene(
            "[domain]\nmax = [1, 1]\n" + domain +
                "[particles]\nspacing = 0.05\n[fluid]\nmin = [0, 0]\nmax = [0.5, 0.5]\n" + rest +
                "[time]\nend = 10\n" + step + more,
            "pool.toml"))),
        derived_(derive(scene_)) {
    const Sample start = sample(scene_);
    x = start.x;
    v = start.v;
    density.assign(x.size() / 2, 1000);
    pressure.assign(x.size() / 2, 0);
    id.resize(x.size() / 2);
    std::iota(id.begin(), id.end(), 0u);
    bounds = {0.002, 0.002, 0.002};
    begin_again();
  }
  Pool(const Pool&) = delete;  // its health monitor refers to it

  /// Restarts the health monitor: the present particles are those after the first step.
  void begin_again() {
    health_ = std::make_unique<Health>(scene_, derived_, view());
    look(1);
  }

  void look(std::int64_t step) {
    health_->look({step, double(step) * 0.0005, 0.0005}, view(), solves, [this] { return bounds; });
  }
  /// The error message of a check that ends the run; empty if the run continues.
  std::string failure(std::int64_t step) {
    try {
      look(step);
    } catch (const Error& e) {
      EXPECT_EQ(Error::Kind::run, e.kind());
      return e.what();
    }
    return "";
  }
  /// The error message for an adaptive run whose time step vanished.
  std::string step_failure() {
    try {
      health_->fail_for_step({10, 0.005, 1e-12}, view(), bounds);
    } catch (const Error& e) {
      return e.what();
    }
  }
  const WatchRecord& record() const { return health_->record(); }
  /// Resumes with the record of a checkpoint, as a restart does.
  void go_on(WatchRecord record) {
    health_ = std::make_unique<Health>(scene_, derived_, view());
    health_->go_on(record);
  }
  const std::vector<Warning>& warnings() const { return health_->warnings(); }
  /// Expects exactly one warning and returns it.
  const Warning& warning() const {
    EXPECT_EQ(1u, warnings().size());
    return warnings().at(0);
  }

  std::vector<Real> x, v, density, pressure;
  std::vector<std::uint64_t> id;
  TimeStepBounds bounds{};
  std::vector<SolveStatistics> solves;

 private:
  ParticleView view() const { return {2, id, x, v, density, pressure, {}}; }

  Scene scene_;
  Derived derived_;
  std::unique_ptr<Health> health_;
};

inline bool contains(const std::string& text, const std::string& part) {
  return text.find(part) != std::string::npos;
}

inline const std::string warn = "[checks]\nwhen_wrong = \"warn\"\n";

/// Gives neighbours opposite velocities along x.
inline void shake(Pool& pool, Real speed) {
  for (std::size_t k = 0; k < pool.id.size(); ++k) pool.v[2 * k] = k % 2 ? speed : -speed;
}

}  // namespace freshet::test
