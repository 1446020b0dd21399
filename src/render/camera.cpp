// SPDX-License-Identifier: MIT
#include "render/camera.h"

#include <algorithm>
#include <numbers>

#include "scene/model/picture_layout.h"

namespace freshet {
namespace {

constexpr double degree = std::numbers::pi / 180;
constexpr double view_margin = 0.06;  // fraction of the picture

/// A scene, and the box that its cameras see by default.
struct Sight {
  const Scene& scene;
  const Bounds& seen;

  Point middle() const { return 0.5 * (seen.low + seen.high); }
  template <class F> void each_corner(F f) const {
    for (int k = 0; k < 8; ++k)
      f({k & 1 ? seen.high.x : seen.low.x, k & 2 ? seen.high.y : seen.low.y,
         k & 4 ? seen.high.z : seen.low.z});
  }
};

/// Rotates p about the vertical, to the right for a viewer who looks at the origin.
Point turned(Point p, double angle) {
  const double c = std::cos(angle), s = std::sin(angle);
  return {p.x * c + p.z * s, p.y, p.z * c - p.x * s};
}

/// The distance from `target` at which an eye in the direction `towards` sees the whole box [m].
double distance_for(const Sight& s, Point target, Point towards, double field_of_view) {
  const View view({target + towards, target, field_of_view}, 1, 1);
  const double up = (1 - 2 * view_margin) * std::tan(field_of_view * degree / 2);
  const PictureLayout layout = picture_layout(s.scene);
  const double across = up * double(layout.view.width) / double(layout.view.height);
  double distance = 0;
  s.each_corner([&](Point corner) {
    const Point q = corner - target;
    const double beyond =
        std::max(std::abs(dot(q, view.right)) / across, std::abs(dot(q, view.up)) / up);
    distance = std::max(distance, beyond - dot(q, view.forward));
  });
  return distance;
}

/// The default position of a camera. That of an orbiting camera sees the whole box from every
/// angle.
Point place_for(const Sight& s, const Scene::Camera& c, Point target) {
  const Point front{0, std::sin(camera_from_above), std::cos(camera_from_above)};
  const int steps = c.orbit == 0 ? 1 : 36;
  double distance = 0;
  for (int k = 0; k < steps; ++k) {
    const double angle = camera_from_right + 2 * std::numbers::pi * k / steps;
    distance = std::max(distance, distance_for(s, target, turned(front, angle), c.field_of_view));
  }
  return target + distance * turned(front, camera_from_right);
}

/// The target that centres the corners of the box in the picture.
Point centered(const Sight& s, const Scene::Camera& c) {
  Point target = s.middle();
  for (int round = 0; round < 6; ++round) {  // a fixed-point iteration
    const View view({place_for(s, c, target), target, c.field_of_view}, 2, 2);
    double left = 1e9, right = -1e9, top = 1e9, bottom = -1e9;
    s.each_corner([&](Point corner) {
      const auto seen = view(corner);
      left = std::min(left, seen.x - 1);
      right = std::max(right, seen.x - 1);
      top = std::min(top, seen.y - 1);
      bottom = std::max(bottom, seen.y - 1);
    });
    const double metres = norm(target - view.eye) / view.focal / 2;
    target += (left + right) * metres * view.right;
    target += -(top + bottom) * metres * view.up;
  }
  return target;
}

Pose pose_of(const Sight& s, const Scene::Camera& c) {
  const bool free = c.target.empty() && c.position.empty() && c.orbit == 0;
  const Point target = free ? centered(s, c) : c.target.empty() ? s.middle() : point_of(c.target);
  return {c.position.empty() ? place_for(s, c, target) : point_of(c.position), target,
          c.field_of_view};
}

/// A smooth curve through the values of key frames: piecewise cubic. The slope at a key frame is
/// that between its neighbours; it is zero at both ends.
class Path {
 public:
  Path(const Scene& s, double time) : cameras_(s.camera) {
    while (k_ + 2 < cameras_.size() && time > cameras_[k_ + 1].time) ++k_;
    step_ = cameras_[k_ + 1].time - cameras_[k_].time;
    t_ = std::clamp((time - cameras_[k_].time) / step_, 0.0, 1.0);
  }
  template <class F> double operator()(F value) const {
    const double a = value(cameras_[k_]), b = value(cameras_[k_ + 1]);
    const double u = t_ * t_ * (3 - 2 * t_), v = 1 - t_;
    return a + u * (b - a) + step_ * t_ * v * (v * slope(value, k_) - t_ * slope(value, k_ + 1));
  }

 private:
  template <class F> double slope(F value, std::size_t k) const {
    if (k == 0 || k + 1 == cameras_.size()) return 0;
    const auto &before = cameras_[k - 1], &after = cameras_[k + 1];
    return (value(after) - value(before)) / (after.time - before.time);
  }
  const std::vector<Scene::Camera>& cameras_;
  std::size_t k_ = 0;
  double step_, t_;
};

Pose between_key_frames(const Sight& s, double time) {
  const Path path(s.scene, time);
  const auto point = [&](auto place) {
    return Point{path([&](const Scene::Camera& c) { return place(c).x; }),
                 path([&](const Scene::Camera& c) { return place(c).y; }),
                 path([&](const Scene::Camera& c) { return place(c).z; })};
  };
  return {point([&](const Scene::Camera& c) { return pose_of(s, c).eye; }),
          point([&](const Scene::Camera& c) { return pose_of(s, c).target; }),
          path([](const Scene::Camera& c) { return c.field_of_view; })};
}

}  // namespace

Pose pose_at(const Scene& scene, double time) {
  return pose_at(scene, time, {point_of(scene.domain.min), point_of(scene.domain.max)});
}

Pose pose_at(const Scene& scene, double time, const Bounds& seen) {
  const Sight sight{scene, seen};
  if (scene.camera.empty()) return pose_of(sight, {});
  if (scene.camera.size() > 1) return between_key_frames(sight, time);
  const Scene::Camera& c = scene.camera[0];
  Pose pose = pose_of(sight, c);
  pose.eye = pose.target + turned(pose.eye - pose.target, c.orbit * degree * time);
  return pose;
}

View::View(const Pose& pose, double width, double height)
    : eye(pose.eye), middle_x(width / 2), middle_y(height / 2) {
  const Point line = pose.target - pose.eye;
  const double distance = norm(line);
  forward = line / distance;
  Point side = cross(forward, {0, 1, 0});
  if (norm(side) < 1e-6) side = {1, 0, 0};  // the camera looks straight down or up
  right = side / norm(side);
  up = cross(right, forward);
  focal = height / 2 / std::tan(pose.field_of_view * degree / 2);
  nearest = 1e-3 * distance;
}

}  // namespace freshet
