// SPDX-License-Identifier: MIT
#include "sim/frame_flows.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <optional>

#include "scene/model/openings.h"

namespace freshet {

struct FrameFlows::Counters {
  virtual ~Counters() = default;
  virtual std::vector<Passed> advance(const Frame& frame) = 0;
};

namespace {

template <int D> class CountersIn final : public FrameFlows::Counters {
 public:
  explicit CountersIn(const Scene& s)
      : volume_(std::pow(s.particles.spacing, D)), counts_(s.counter.size()) {
    for (const Scene::Counter& c : s.counter) pieces_.push_back(opening_of<D>(c));
    for (int k = 0; k < D; ++k)
      if (s.periodic(k))
        component(period_, k) = s.domain.max[std::size_t(k)] - s.domain.min[std::size_t(k)];
  }

  std::vector<FrameFlows::Passed> advance(const Frame& frame) override {
    Places now = places_of(frame);
    std::vector<FrameFlows::Passed> all(counts_.size());
    const double seconds = time_ ? frame.time - *time_ : 0;
    for (std::size_t c = 0; c < counts_.size(); ++c) {
      const std::int64_t count = crossed(pieces_[c], now);
      counts_[c] += count;
      all[c] = {volume_ * double(counts_[c]), seconds > 0 ? volume_ * double(count) / seconds : 0};
    }
    time_ = frame.time;
    before_ = std::move(now);
    return all;
  }

 private:
  struct Place {
    std::uint64_t id;
    Vec<D, double> x;
  };
  using Places = std::vector<Place>;  // in the order of ids

  static Places places_of(const Frame& frame) {
    Places all(frame.size());
    for (std::size_t i = 0; i < all.size(); ++i) {
      all[i].id = frame.id[i];
      for (std::size_t d = 0; d < D; ++d) component(all[i].x, int(d)) = frame.x[D * i + d];
    }
    const auto earlier = [](const Place& a, const Place& b) { return a.id < b.id; };
    if (!std::is_sorted(all.begin(), all.end(), earlier))
      std::sort(all.begin(), all.end(), earlier);
    return all;
  }
  std::int64_t crossed(const Opening<D>& piece, const Places& now) const {
    std::int64_t count = 0;
    auto from = before_.begin();
    for (const Place& to : now) {
      while (from != before_.end() && from->id < to.id) ++from;
      if (from == before_.end()) break;
      if (from->id == to.id) count += crossings(piece, from->x, to.x, period_);
    }
    return count;
  }

  double volume_;
  std::vector<Opening<D>> pieces_;
  Vec<D, double> period_{};
  std::vector<std::int64_t> counts_;
  std::optional<double> time_;  // of the frame before
  Places before_;
};

}  // namespace

FrameFlows::FrameFlows(const Scene& scene) {
  if (scene.dimension() == 2) counters_ = std::make_unique<CountersIn<2>>(scene);
  else counters_ = std::make_unique<CountersIn<3>>(scene);
}
FrameFlows::~FrameFlows() = default;

std::vector<FrameFlows::Passed> FrameFlows::advance(const Frame& frame) {
  return counters_->advance(frame);
}

}  // namespace freshet
