// SPDX-License-Identifier: MIT
#include "run/frame_source.h"

#include <algorithm>
#include <cmath>

namespace freshet {
namespace {

/// Values between those at the start (s = 0) and the end (s = 1) of a step.
class Between {
 public:
  Between(double time, double start, double end)
      : step_(end - start), s_(step_ > 0 ? (time - start) / step_ : 1) {}

  bool nearer_to_start() const { return s_ < 0.5; }
  double linear(double a, double b) const { return (1 - s_) * a + s_ * b; }
  double hermite(double x0, double v0, double x1, double v1) const {
    const double t = 1 - s_;
    return t * t * ((1 + 2 * s_) * x0 + s_ * step_ * v0) +
           s_ * s_ * ((1 + 2 * t) * x1 - t * step_ * v1);
  }
  double from_start(double x, double v) const { return x + s_ * step_ * v; }
  double from_end(double x, double v) const { return x - (1 - s_) * step_ * v; }

 private:
  double step_, s_;
};

/// The ends of a periodic axis.
struct Periodic {
  bool periodic = false;
  double low = 0, length = 0;
  Periodic(const Scene& s, std::size_t axis) : periodic(s.periodic(int(axis))) {
    low = s.domain.min[axis];
    length = s.domain.max[axis] - low;
  }
  /// The image of x that is nearest to `to`.
  double near(double x, double to) const {
    return periodic ? x - length * std::round((x - to) / length) : x;
  }
  double inside(double x) const {
    return periodic ? x - length * std::floor((x - low) / length) : x;
  }
};

class FrameBetween {
 public:
  FrameBetween(const Frame& a, const Frame& b, double time, const Scene& s)
      : a_(a), b_(b), between_(time, a.time, b.time) {
    for (std::size_t k = 0; k < std::size_t(s.dimension()); ++k) axes_.emplace_back(s, k);
    out_.dimension = s.dimension();
    out_.step = b.step;
    out_.time = time;
  }

  Frame frame() && {
    std::size_t i = 0, j = 0;
    while (i < a_.size() || j < b_.size()) {
      const bool left = j == b_.size() || (i < a_.size() && a_.id[i] < b_.id[j]);
      const bool entered = i == a_.size() || (j < b_.size() && b_.id[j] < a_.id[i]);
      if (left) add_single(a_, i++, true);
      else if (entered) add_single(b_, j++, false);
      else add_pair(i++, j++);
    }
    for (std::size_t k = 0; k < b_.bodies.size(); ++k)
      out_.bodies.push_back(body(a_.bodies[k], b_.bodies[k]));
    add_whitewater();
    return std::move(out_);
  }

 private:
  void add_pair(std::size_t i, std::size_t j) {
    const std::size_t D = axes_.size();
    out_.id.push_back(b_.id[j]);
    for (std::size_t k = 0; k < D; ++k) {
      const double x0 = a_.x[D * i + k], v0 = a_.v[D * i + k], v1 = b_.v[D * j + k];
      const double x1 = axes_[k].near(b_.x[D * j + k], x0);
      out_.x.push_back(float(axes_[k].inside(between_.hermite(x0, v0, x1, v1))));
      out_.v.push_back(float(between_.linear(v0, v1)));
    }
    const bool computed = a_.step > 0;  // densities and pressures are those of a step
    const auto mix = [&](float a, float b) { return computed ? float(between_.linear(a, b)) : b; };
    out_.density.push_back(mix(a_.density[i], b_.density[j]));
    out_.pressure.push_back(mix(a_.pressure[i], b_.pressure[j]));
    if (!b_.liquid.empty()) out_.liquid.push_back(b_.liquid[j]);
  }
  /// A particle that left or entered the fluid in the step.
  void add_single(const Frame& f, std::size_t i, bool at_start) {
    if (at_start != between_.nearer_to_start()) return;
    const std::size_t D = axes_.size();
    out_.id.push_back(f.id[i]);
    for (std::size_t k = 0; k < D; ++k) {
      const double x = f.x[D * i + k], v = f.v[D * i + k];
      const double moved = at_start ? between_.from_start(x, v) : between_.from_end(x, v);
      out_.x.push_back(float(axes_[k].inside(moved)));
      out_.v.push_back(f.v[D * i + k]);
    }
    out_.density.push_back(f.density[i]);
    out_.pressure.push_back(f.pressure[i]);
    if (!f.liquid.empty()) out_.liquid.push_back(f.liquid[i]);
  }
  /// The whitewater of the end of the step, moved back.
  void add_whitewater() {
    const std::size_t D = axes_.size();
    WhitewaterFrame& w = out_.whitewater = b_.whitewater;
    for (std::size_t i = 0; i < w.x.size(); ++i)
      w.x[i] = float(axes_[i % D].inside(between_.from_end(w.x[i], w.v[i])));
    for (float& age : w.age) age = float(std::max(0.0, between_.from_end(age, 1)));
  }
  /// The force and the torque are those of the step.
  BodyState body(const BodyState& a, const BodyState& b) const {
    BodyState out = b;
    double same_side = 0, norm2 = 0;  // q and -q are the same orientation
    for (std::size_t k = 0; k < 4; ++k) same_side += a.orientation[k] * b.orientation[k];
    for (std::size_t k = 0; k < 4; ++k) {
      out.orientation[k] =
          between_.linear(std::copysign(1.0, same_side) * a.orientation[k], b.orientation[k]);
      norm2 += out.orientation[k] * out.orientation[k];
    }
    for (double& q : out.orientation) q /= std::sqrt(norm2);
    for (std::size_t k = 0; k < 3; ++k) {
      const double x0 = a.position[k], x1 = b.position[k];
      out.position[k] = between_.hermite(
          x0, a.velocity[k], k < axes_.size() ? axes_[k].near(x1, x0) : x1, b.velocity[k]);
      out.velocity[k] = between_.linear(a.velocity[k], b.velocity[k]);
      out.angular_velocity[k] = between_.linear(a.angular_velocity[k], b.angular_velocity[k]);
    }
    return out;
  }

  const Frame &a_, &b_;
  Between between_;
  std::vector<Periodic> axes_;
  Frame out_;
};

}  // namespace

Frame frame_between(const Frame& earlier, const Frame& later, double time, const Scene& scene) {
  return FrameBetween(earlier, later, time, scene).frame();
}

void FrameSource::before_step(bool keep) {
  earlier_ = keep ? std::make_shared<const Frame>(sim_.frame()) : nullptr;
  later_ = last_ = nullptr;
}

std::shared_ptr<const Frame> FrameSource::at(double time) {
  if (last_ && last_->time == time) return last_;
  if (!later_) later_ = std::make_shared<const Frame>(sim_.frame());
  last_ = later_;
  if (earlier_ && time < later_->time)
    last_ = std::make_shared<const Frame>(frame_between(*earlier_, *later_, time, sim_.scene()));
  return last_;
}

}  // namespace freshet
