// SPDX-License-Identifier: MIT
#include "view/camera.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace freshet::view {
namespace {

constexpr double degree = std::numbers::pi / 180;
constexpr double steepest = 89.5 * degree;

}  // namespace

Camera::Camera(const Start& s, double aspect)
    : target(s.target),
      distance(s.distance),
      yaw(s.yaw),
      pitch(s.pitch),
      field_of_view(s.field_of_view),
      flat_(s.flat) {
  if (flat_) height = std::max(s.height, s.width / aspect);
  else distance *= std::max(1.0, s.width / s.height / aspect);  // narrow windows show all, too
}

void Camera::orbit(double right, double up) {
  if (flat_) return pan(right, up);
  yaw -= std::numbers::pi * right;
  pitch = std::clamp(pitch - std::numbers::pi * up, -steepest, steepest);
}

void Camera::pan(double right_part, double up_part) {
  const double metres = height_at(target);
  target += -metres * right_part * right() + -metres * up_part * up();
}

void Camera::zoom(double factor, double x, double y, double aspect) {
  if (flat_) {
    const double gone = (1 - factor) * height / 2;
    target += Point{gone * x * aspect, gone * y, 0};
    height *= factor;
  } else {
    distance *= factor;
  }
}

Point Camera::forward() const {
  if (flat_) return {0, 0, -1};
  return {-std::cos(pitch) * std::sin(yaw), -std::sin(pitch), -std::cos(pitch) * std::cos(yaw)};
}
Point Camera::right() const {
  return flat_ ? Point{1, 0, 0} : Point{std::cos(yaw), 0, -std::sin(yaw)};
}
Point Camera::up() const { return cross(right(), forward()); }
Point Camera::eye() const { return target - distance * forward(); }

Matrix Camera::view() const {
  const Point x = right(), y = up(), z = -1.0 * forward(), e = eye();
  const auto f = [](double a) { return float(a); };
  return {f(x.x), f(y.x), f(z.x), 0, f(x.y),        f(y.y),        f(z.y),        0,
          f(x.z), f(y.z), f(z.z), 0, f(-dot(x, e)), f(-dot(y, e)), f(-dot(z, e)), 1};
}

Matrix Camera::projection(double aspect) const {
  const double n = nearest(), r = farthest();
  Matrix m{};
  if (flat_) {
    m[0] = float(2 / (height * aspect));
    m[5] = float(2 / height);
    m[10] = float(-2 / (r - n));
    m[14] = float(-(r + n) / (r - n));
    m[15] = 1;
    return m;
  }
  const double focal = 1 / std::tan(field_of_view * degree / 2);
  m[0] = float(focal / aspect);
  m[5] = float(focal);
  m[10] = float((r + n) / (n - r));
  m[11] = -1;
  m[14] = float(2 * r * n / (n - r));
  return m;
}

Camera::Ray Camera::ray(double x, double y, double aspect) const {
  if (flat_) return {target + Point{x * aspect * height / 2, y * height / 2, distance}, {0, 0, -1}};
  const double half = std::tan(field_of_view * degree / 2);
  const Point along = forward() + x * aspect * half * right() + y * half * up();
  return {eye(), along / norm(along)};
}

Point Camera::on_plane(double x, double y, double aspect, Point point) const {
  const Ray r = ray(x, y, aspect);
  const double depth = dot(point - r.from, forward()) / dot(r.along, forward());
  return r.from + depth * r.along;
}

double Camera::height_at(Point point) const {
  if (flat_) return height;
  return 2 * std::tan(field_of_view * degree / 2) * std::abs(dot(point - eye(), forward()));
}

}  // namespace freshet::view
