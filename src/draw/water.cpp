// SPDX-License-Identifier: MIT
#include "draw/water.h"

#include <algorithm>

#include "draw/shaders.h"

namespace freshet::gl {
namespace {

Program program(const char* name, const ShaderSource& s) { return {name, s.vertex, s.fragment}; }

/// Light that a length of the domain lets through, and the colour of deep water.
constexpr float absorbed[3] = {3.6f, 1.1f, 0.6f};
constexpr float deep[3] = {0.02f, 0.20f, 0.30f};
constexpr int rounds = 2;          // of the filter
constexpr float filter_width = 4;  // radius of the filter in radii of a ball
constexpr float filter_range = 3;  // in radii of a ball

}  // namespace

Water::Water()
    : depth_(program("depth", depth_shader)),
      thickness_(program("thickness", thickness_shader)),
      smooth_(program("smooth", smooth_shader)),
      water_(program("water", water_shader)),
      copy_(program("copy", copy_shader)),
      screen_({2}),
      behind_(GL_RGBA8),
      near_(GL_R32F),
      turned_(GL_R32F),
      thick_(GL_R16F) {
  screen_.fill({-1, -1, 1, -1, -1, 1, 1, 1});
}

void Water::splat(const Program& p, const Vertices& balls, const Shape& s, int height) {
  p.use();
  p.set("view", s.view);
  p.set("projection", s.projection);
  p.set("radius", s.radius);
  p.set("height", float(height));
  p.set("slice_axis", s.slice.axis);
  p.set("slice_middle", float(s.slice.middle));
  p.set("slice_half", float(s.slice.thickness / 2));
  p.set("chord", s.chord);
  balls.draw(GL_POINTS);
}

void Water::smooth(const Shape& s) {
  const auto pixels = float(near_.height()) / (2 * s.half_height);  // per metre at a distance of 1
  smooth_.use();
  smooth_.set("range", filter_range * s.radius);
  smooth_.set("width", filter_width * s.radius * pixels);
  smooth_.set("longest", 32.0f);
  glDisable(GL_DEPTH_TEST);
  for (int k = 0; k < 2 * rounds; ++k) {
    Target &from = k % 2 ? turned_ : near_, &to = k % 2 ? near_ : turned_;
    to.bind();
    smooth_.set_texture("depth", 0, from.color());
    smooth_.set("stride", k % 2 ? 0.0f : 1 / float(near_.width()),
                k % 2 ? 1 / float(near_.height()) : 0.0f);
    screen_.draw(GL_TRIANGLE_STRIP);
  }
  glEnable(GL_DEPTH_TEST);
}

void Water::draw(const Vertices& balls, const Shape& s, const Painter::Region& region, int detail,
                 GLuint into) {
  const int width = region.width, height = region.height;
  const auto part = [](int pixels, int d) { return std::max(1, pixels / d); };
  for (Target* t : {&near_, &turned_}) t->resize(part(width, detail), part(height, detail));
  thick_.resize(part(width, 2 * detail), part(height, 2 * detail));
  glClearColor(0, 0, 0, 0);
  near_.bind();
  glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
  splat(depth_, balls, s, near_.height());
  thick_.bind();
  glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
  glDisable(GL_DEPTH_TEST);
  glEnable(GL_BLEND);
  glBlendFunc(GL_ONE, GL_ONE);
  splat(thickness_, balls, s, thick_.height());
  glDisable(GL_BLEND);
  glEnable(GL_DEPTH_TEST);
  smooth(s);
  glBindFramebuffer(GL_FRAMEBUFFER, into);
  glViewport(region.left, 0, width, height);
  glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
  copy_.use();
  copy_.set_texture("scene", 0, behind_.color());
  copy_.set_texture("scene_depth", 1, behind_.depth());
  screen_.draw(GL_TRIANGLE_STRIP);
  water_.use();
  water_.set_texture("depth", 0, near_.color());
  water_.set_texture("thick", 1, thick_.color());
  water_.set_texture("scene", 2, behind_.color());
  water_.set_texture("scene_depth", 3, behind_.depth());
  water_.set("projection", s.projection);
  water_.set("texel", 1 / float(near_.width()), 1 / float(near_.height()));
  water_.set("half_size", s.half_width, s.half_height);
  water_.set("light", float(s.light.x), float(s.light.y), float(s.light.z));
  water_.set("up", float(s.up.x), float(s.up.y), float(s.up.z));
  water_.set("absorption", absorbed[0] / s.length, absorbed[1] / s.length, absorbed[2] / s.length);
  water_.set("deep", deep[0], deep[1], deep[2]);
  water_.set("longest_path", 0.5f * s.length);
  screen_.draw(GL_TRIANGLE_STRIP);
  glActiveTexture(GL_TEXTURE0);
}

}  // namespace freshet::gl
