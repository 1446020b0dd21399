// SPDX-License-Identifier: MIT
#include "draw/painter.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "draw/shaders.h"
#include "draw/water.h"
#include "render/floor.h"
#include "render/foam.h"

namespace freshet::gl {
namespace {

constexpr double disc_diameter = 1.15, ball_diameter = 1;  // [spacings]; discs close the gaps
constexpr double splat_radius = 0.95;                      // of a ball of the liquid [spacings]
constexpr view::Matrix resting_place{1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1};
constexpr float floor_reach = 2.2f;  // of the floor over half the domain's diagonal

Program program(const char* name, const ShaderSource& s) { return {name, s.vertex, s.fragment}; }

/// A direction of the scene as the camera sees it.
Point turned(const view::Matrix& m, Point p) {
  return {double(m[0]) * p.x + double(m[4]) * p.y + double(m[8]) * p.z,
          double(m[1]) * p.x + double(m[5]) * p.y + double(m[9]) * p.z,
          double(m[2]) * p.x + double(m[6]) * p.y + double(m[10]) * p.z};
}

view::Tint tint_of(Color c) { return {float(c.r) / 255, float(c.g) / 255, float(c.b) / 255, 1}; }

}  // namespace

/// What the shaders need of the camera.
struct Painter::Sight {
  view::Matrix view, projection;
  Point light, up;
  int width, height;
  double field_of_view;
  float radius;
};

Painter::Painter()
    : ball_(program("ball", ball_shader)),
      disc_(program("disc", disc_shader)),
      solid_(program("solid", solid_shader)),
      line_(program("line", line_shader)),
      floor_(program("floor", floor_shader)),
      foam_(program("foam", foam_shader)),
      balls_({4}),
      foam_points_({3}),
      floor_square_({3}) {
  glGenTextures(1, &map_);
  glBindTexture(GL_TEXTURE_2D, map_);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_S, GL_CLAMP_TO_EDGE);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_T, GL_CLAMP_TO_EDGE);
#ifndef __EMSCRIPTEN__
  glEnable(GL_PROGRAM_POINT_SIZE);
#endif
}

Painter::~Painter() { glDeleteTextures(1, &map_); }

void Painter::set_stage(const view::Stage& stage) {
  flat_ = stage.flat;
  spacing_ = stage.spacing;
  glow_ = stage.glow;
  low_ = stage.low;
  high_ = stage.high;
  parts_.clear();
  for (const view::Part& part : stage.parts) {
    Moving moving{part.kind,     part.fill,     part.edge,    Vertices({3, 3}),
                  Vertices({3}), Vertices({4}), resting_place};
    moving.triangles.fill(part.triangles);
    moving.lines.fill(part.lines);
    moving.points.fill(part.points);
    parts_.push_back(std::move(moving));
  }
  const Point middle = 0.5 * (low_ + high_);
  const double reach = floor_reach * norm(high_ - low_) / 2;
  const auto y = float(low_.y - 1e-3 * (high_.y - low_.y));
  std::vector<float> square;
  for (const double x : {-reach, reach})
    for (const double z : {-reach, reach})
      square.insert(square.end(), {float(middle.x + x), y, float(middle.z + z)});
  floor_square_.fill(square);
}

void Painter::set_frame(const view::Shown& shown) {
  balls_.fill(shown.balls);
  glBindTexture(GL_TEXTURE_2D, map_);
  glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA8, view::map_size, 1, 0, GL_RGBA, GL_UNSIGNED_BYTE,
               shown.map.data());
  foam_points_.fill(shown.foam);
  for (std::size_t k = 0; k < parts_.size() && 16 * (k + 1) <= shown.placements.size(); ++k)
    std::copy_n(&shown.placements[16 * k], 16, parts_[k].placement.begin());
}

void Painter::draw_floor(const Sight& s, const Look& look) {
  const bool bright = look.style == Style::water;
  const view::Tint plain{look.background.r * 0.8f + 0.06f, look.background.g * 0.8f + 0.06f,
                         look.background.b * 0.8f + 0.07f, 1};
  floor_.use();
  floor_.set("view", s.view);
  floor_.set("projection", s.projection);
  floor_.set("fill", bright ? view::Tint{0.80f, 0.78f, 0.74f, 1} : plain);
  floor_.set("horizon", look.background);
  const Point middle = 0.5 * (low_ + high_);
  floor_.set("middle", float(middle.x), float(middle.z));
  floor_.set("tile", float(std::max(high_.x - low_.x, high_.z - low_.z) / 12));
  floor_.set("reach", floor_reach * float(norm(high_ - low_) / 2));
  floor_.set("contrast", bright ? 0.22f : 0.12f);
  floor_square_.draw(GL_TRIANGLE_STRIP);
}

void Painter::draw_stage(const Sight& s, const Look& look) {
  const auto shown = [&](const Moving& m) {
    using Kind = view::Part::Kind;
    return m.kind == Kind::wall    ? look.walls
           : m.kind == Kind::body  ? look.bodies
           : m.kind == Kind::probe ? look.probes
                                   : true;
  };
  if (look.floor && !flat_) draw_floor(s, look);
  for (const bool filled : {true, false}) {
    const Program& p = filled ? solid_ : line_;
    p.use();
    p.set("view", s.view);
    p.set("projection", s.projection);
    p.set("light", float(s.light.x), float(s.light.y), float(s.light.z));
    p.set("up", float(s.up.x), float(s.up.y), float(s.up.z));
    p.set("flatness", flat_ ? 1.0f : 0.0f);
    for (const Moving& m : parts_) {
      if (!shown(m)) continue;
      p.set("placement", m.placement);
      p.set("fill", filled ? m.fill : m.edge);
      if (filled) m.triangles.draw(GL_TRIANGLES);
      else m.lines.draw(GL_LINES);
    }
  }
}

/// The program of balls or, in 2D, of discs, in one colour until "fill" is changed.
const Program& Painter::use_balls(const Sight& s, const Look& look) const {
  const Program& p = flat_ ? disc_ : ball_;
  p.use();
  p.set("view", s.view);
  p.set("projection", s.projection);
  p.set("radius", s.radius);
  p.set("height", float(s.height));
  p.set("grown", flat_ ? 1.0f : 0.0f);  // half a pixel around
  p.set("marked", -1);
  p.set("fill", view::Tint{0, 0, 0, 0});
  p.set("slice_axis", look.slice.axis);
  p.set("slice_middle", float(look.slice.middle));
  p.set("slice_half", float(look.slice.thickness / 2));
  p.set_texture("map", 0, map_);
  if (flat_) p.set("softness", look.soft ? 1.0f : 0.0f);
  else p.set("light", float(s.light.x), float(s.light.y), float(s.light.z));
  return p;
}

/// Walls of points.
void Painter::draw_points(const Sight& s, const Look& look) {
  if (!look.walls) return;
  for (const Moving& m : parts_) {
    if (m.points.count() == 0) continue;
    const Program& p = use_balls(s, look);
    if (flat_) p.set("glow", 0.0f);
    p.set("fill", m.fill);
    m.points.draw(GL_POINTS);
  }
}

void Painter::draw_balls(const Sight& s, const Look& look) {
  const Program& p = use_balls(s, look);
  p.set("marked", look.marked ? int(*look.marked) : -1);
  if (flat_) return draw_discs(look);
  balls_.draw(GL_POINTS);
}

/// Discs with smooth edges blend, and so does the light of glowing dots.
void Painter::draw_discs(const Look& look) {
  const bool glows = glow_ > 0;
  disc_.set("glow", glows ? 1.0f : 0.0f);
  if (glows) disc_.set("radius", look.size * glow_);
  if (glows || look.soft) {
    glEnable(GL_BLEND);
    glBlendFunc(glows ? GL_ONE : GL_SRC_ALPHA, glows ? GL_ONE : GL_ONE_MINUS_SRC_ALPHA);
    glDepthMask(GL_FALSE);
  }
  balls_.draw(GL_POINTS);
  glDepthMask(GL_TRUE);
  glDisable(GL_BLEND);
}

void Painter::draw_foam(const Sight& s, const Look& look, bool on_water) {
  if (!look.foam || foam_points_.count() == 0) return;
  foam_.use();
  foam_.set("view", s.view);
  foam_.set("projection", s.projection);
  foam_.set("radius", float(foam_radius) * spacing_ * (on_water ? 1.5f : 1));
  foam_.set("height", float(s.height));
  foam_.set("forward", on_water ? 2 * spacing_ : 0.0f);
  foam_.set("slice_axis", look.slice.axis);
  foam_.set("slice_middle", float(look.slice.middle));
  foam_.set("slice_half", float(look.slice.thickness / 2));
  view::Tint white = tint_of(foam_color);
  white.a = on_water ? 0.6f : 0.9f;
  foam_.set("fill", white);
  glEnable(GL_BLEND);
  glBlendFunc(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA);
  glDepthMask(GL_FALSE);
  foam_points_.draw(GL_POINTS);
  glDepthMask(GL_TRUE);
  glDisable(GL_BLEND);
}

void Painter::draw(const view::Camera& camera, const Look& look, const Region& region,
                   GLuint into) {
  const int width = region.width, height = region.height;
  const double aspect = region.aspect();
  Sight s{camera.view(), camera.projection(aspect), {}, {}, width, height, camera.field_of_view, 0};
  s.light = turned(s.view, light_direction());
  s.up = turned(s.view, {0, 1, 0});
  s.radius = look.size * spacing_ * float((flat_ ? disc_diameter : ball_diameter) / 2);
  const bool water = look.style == Style::water && !flat_;
  if (water && !water_) water_ = std::make_unique<Water>();
  if (water) {
    water_->behind().resize(width, height);
    water_->behind().bind();
  } else {
    glBindFramebuffer(GL_FRAMEBUFFER, into);
    glViewport(region.left, 0, width, height);
  }
  glEnable(GL_DEPTH_TEST);
  glDisable(GL_BLEND);
  glDepthMask(GL_TRUE);
  glClearColor(look.background.r, look.background.g, look.background.b, 1);
  glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
  draw_stage(s, look);
  draw_points(s, look);
  if (!water) {
    draw_balls(s, look);
  } else {
    const double half = std::tan(camera.field_of_view * std::numbers::pi / 360);
    const auto r = float(splat_radius) * spacing_;
    const double share = std::pow(splat_radius, 3) * 4 / 3 * std::numbers::pi;
    const Point size = high_ - low_;
    water_->draw(balls_,
                 {s.view, s.projection, r, float(1 / share), float(half * aspect), float(half),
                  float(std::max({size.x, size.y, size.z})), look.slice, s.light, s.up},
                 region, look.water_detail, into);
  }
  draw_foam(s, look, water);
}

}  // namespace freshet::gl
