// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cmath>

#include "scene/model/picture_layout.h"
#include "view/camera.h"

namespace freshet::view {
namespace {

Camera::Start flat_start(const Scene& scene, const PictureLayout& layout) {
  const PictureRegion region = picture_region(scene);
  Camera::Start start;
  start.flat = true;
  start.target = {(region.min[0] + region.max[0]) / 2, (region.min[1] + region.max[1]) / 2, 0};
  start.distance = std::max(region.extent(0), region.extent(1));
  // as much room around the region as a picture of the scene has
  const double margins = 2.0 * picture_margin;
  start.height = region.extent(1) * layout.view.height / (layout.view.height - margins);
  start.width = region.extent(0) * layout.view.width / (layout.view.width - margins);
  return start;
}

}  // namespace

Camera::Start start_of(const Scene& scene, double time) {
  const PictureLayout layout = picture_layout(scene);
  if (scene.dimension() == 2) return flat_start(scene, layout);
  const Pose pose = pose_at(scene, time);
  const Point back = pose.eye - pose.target;
  Camera::Start start;
  start.target = pose.target;
  start.distance = norm(back);
  start.yaw = std::atan2(back.x, back.z);
  start.pitch = std::asin(std::clamp(back.y / start.distance, -1.0, 1.0));
  start.field_of_view = pose.field_of_view;
  start.width = layout.view.width;
  start.height = layout.view.height;
  return start;
}

Camera Camera::of(const Scene& scene, double time, double aspect) {
  return {start_of(scene, time), aspect};
}

}  // namespace freshet::view
