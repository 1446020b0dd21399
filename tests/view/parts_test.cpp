// SPDX-License-Identifier: MIT
// Cameras, picking and shapes.
#include <gtest/gtest.h>

#include <cmath>

#include "cli/files.h"
#include "render/camera.h"
#include "scene/model/picture_layout.h"
#include "scene/model/setup.h"
#include "view/actions.h"
#include "view/pick.h"
#include "view/shapes.h"
#include "view/stage.h"

namespace freshet::view {
namespace {

Scene box_scene(int dimension) {
  Scene s;
  s.domain.max = dimension == 2 ? Vector{2, 1} : Vector{2, 1, 0.5};
  s.particles.spacing = 0.1;
  return with_defaults(s);
}

Scene::Body moved_ball() {
  Scene::Body ball;
  ball.shape = Shape::sphere;
  ball.center = {1.5, 0.5, 0.25};
  ball.radius = 0.2;
  ball.motion = BodyMotion::moved;
  return ball;
}

/// Where a camera draws a point: -1 to 1 from the middle to the edges.
Point drawn(const Camera& camera, double aspect, Point p) {
  const Matrix v = camera.view(), m = camera.projection(aspect);
  const auto times = [](const Matrix& a, const double(&x)[4], double(&y)[4]) {
    for (std::size_t r = 0; r < 4; ++r) {
      y[r] = 0;
      for (std::size_t c = 0; c < 4; ++c) y[r] += double(a[4 * c + r]) * x[c];
    }
  };
  const double at[4] = {p.x, p.y, p.z, 1};
  double eye[4], clip[4];
  times(v, at, eye);
  times(m, eye, clip);
  return {clip[0] / clip[3], clip[1] / clip[3], clip[2] / clip[3]};
}

TEST(ViewCamera, DrawsAPointWhereThePicturesOfTheSceneHaveIt) {
  const Scene scene = box_scene(3);
  const PictureLayout layout = picture_layout(scene);
  const double width = layout.view.width, height = layout.view.height;
  const Camera camera = Camera::of(scene, 0, width / height);
  const View pictures(pose_at(scene, 0), width, height);
  for (const Point p : {Point{0, 0, 0}, Point{2, 1, 0.5}, Point{0.3, 0.9, 0.1}}) {
    const View::Seen seen = pictures(p);
    const Point here = drawn(camera, width / height, p);
    EXPECT_NEAR((here.x + 1) / 2 * width, seen.x, 0.05);
    EXPECT_NEAR((1 - here.y) / 2 * height, seen.y, 0.05);
  }
}

TEST(ViewCamera, NarrowWindowShowsTheWidthOfThePicture) {
  const Scene scene = box_scene(3);
  const Camera wide = Camera::of(scene, 0, 2), narrow = Camera::of(scene, 0, 0.5);
  for (const Point p : {Point{0, 0, 0.5}, Point{2, 1, 0.5}}) {
    EXPECT_LT(std::abs(drawn(wide, 2, p).x), 1);
    EXPECT_LT(std::abs(drawn(narrow, 0.5, p).x), 1);
  }
}

TEST(ViewCamera, RayOfAPlaceMeetsThePointDrawnThere) {
  for (const int dimension : {2, 3}) {
    Camera camera = Camera::of(box_scene(dimension), 0, 1.5);
    camera.zoom(0.7, 0.2, 0.1, 1.5);
    camera.pan(0.05, -0.02);
    if (dimension == 3) camera.orbit(0.3, 0.1);
    const Point p{0.7, 0.4, dimension == 3 ? 0.3 : 0.0}, at = drawn(camera, 1.5, p);
    const Camera::Ray ray = camera.ray(at.x, at.y, 1.5);
    const Point arm = p - ray.from;
    EXPECT_NEAR(norm(arm - dot(arm, ray.along) * ray.along), 0, 1e-5);
    EXPECT_NEAR(norm(camera.on_plane(at.x, at.y, 1.5, p) - p), 0, 1e-5);
  }
}

TEST(ViewCamera, ZoomIn2DKeepsThePlaceUnderTheCursor) {
  Camera camera = Camera::of(box_scene(2), 0, 1.5);
  const Point before = camera.on_plane(0.4, -0.3, 1.5, {0, 0, 0});
  camera.zoom(0.5, 0.4, -0.3, 1.5);
  EXPECT_NEAR(norm(camera.on_plane(0.4, -0.3, 1.5, {0, 0, 0}) - before), 0, 1e-12);
}

Frame three_particles() {
  Frame f;
  f.dimension = 3;
  f.id = {2, 5, 9};
  f.x = {0, 0, 0, 0, 0, 1, 0.5f, 0, 0};
  f.v.resize(9);
  f.density.resize(3);
  f.pressure.resize(3);
  return f;
}

TEST(ViewPick, FindsTheNearestBallOnTheRayAndObeysTheSlice) {
  const Frame f = three_particles();
  const Camera::Ray ray{{0, 0, 5}, {0, 0, -1}};
  EXPECT_EQ(pick(f, ray, 0.1), std::size_t(1));
  EXPECT_EQ(pick(f, ray, 0.1, {2, 0, 0.5}), std::size_t(0));
  EXPECT_FALSE(pick(f, {{0.3, 0, 5}, {0, 0, -1}}, 0.1));
  EXPECT_FALSE(pick(f, {{0, 0, -5}, {0, 0, -1}}, 0.1)) << "behind the camera";
  EXPECT_EQ(find_id(f, 9), std::size_t(2));
  EXPECT_FALSE(find_id(f, 4));
}

TEST(ViewPick, NeighborsAreThoseWithinTheSupport) {
  const Frame f = three_particles();
  EXPECT_EQ(neighbors_of(f, 0, 0.6), (std::vector<std::size_t>{2}));
  EXPECT_EQ(neighbors_of(f, 0, 1.1).size(), 2u);
  EXPECT_TRUE(neighbors_of(f, 0, 0.5).empty()) << "the kernel is 0 at its support";
}

double area_of(const std::vector<Vec<2, double>>& p,
               const std::vector<TriangleMesh::Triangle>& triangles) {
  double area = 0;
  for (const auto& [a, b, c] : triangles) {
    const auto &u = p[std::size_t(a)], &v = p[std::size_t(b)], &w = p[std::size_t(c)];
    const double part = ((v.x - u.x) * (w.y - u.y) - (v.y - u.y) * (w.x - u.x)) / 2;
    EXPECT_GT(part, 0);
    area += part;
  }
  return area;
}

TEST(ViewShapes, ConcavePolygonIsFilledOnce) {
  const std::vector<Vec<2, double>> arrow{{0, 0}, {2, 0}, {2, 2}, {1, 0.5}, {0, 2}};
  EXPECT_NEAR(area_of(arrow, triangulate(arrow)), 2.5, 1e-12);
}

TEST(ViewShapes, DomainWallsBodiesAndProbesHaveParts) {
  Scene s = box_scene(3);
  Scene::Wall wall;
  wall.shape = Shape::box;
  wall.min = {0.5, 0, 0};
  wall.max = {0.7, 0.4, 0.5};
  s.wall.push_back(wall);
  Scene::Wall plane;
  plane.shape = Shape::plane;
  plane.point = {1, 0.5, 0.25};
  plane.normal = {0, 1, 0};
  s.wall.push_back(plane);
  s.body.push_back(moved_ball());
  Scene::Probe gauge;
  gauge.kind = ProbeKind::point;
  gauge.at = {1, 0.2, 0.2};
  s.probe.push_back(gauge);
  const std::vector<Part> parts = parts_of(with_defaults(s));
  ASSERT_EQ(parts.size(), 5u);
  EXPECT_EQ(parts[0].lines.size(), 12u * 6) << "edges of the domain";
  EXPECT_EQ(parts[1].triangles.size(), 12u * 18) << "a box";
  EXPECT_EQ(parts[1].lines.size(), 12u * 6) << "without the diagonals of its faces";
  EXPECT_EQ(parts[2].triangles.size(), 2u * 18) << "a plane across the domain";
  EXPECT_GT(parts[3].triangles.size(), 1000u);
  EXPECT_TRUE(parts[3].lines.empty()) << "a ball has no sharp edges";
  EXPECT_EQ(parts[4].lines.size(), 3u * 6) << "a cross";
  Frame frame;
  frame.dimension = 3;
  frame.bodies.resize(1);
  frame.bodies[0].position = {1.5, 0.75, 0.25};
  EXPECT_NEAR(placement_of(parts[3], frame)[13], 0.25, 1e-6);
}

TEST(ViewShapes, WallOfPointsHasThePointsOfItsFile) {
  const test::TemporaryFolder folder;
  test::write_text(folder / "wall.csv", "x,y\n0.5,0.25\n0.75,0.5\n");
  Scene s = box_scene(2);
  Scene::Wall wall;
  wall.shape = Shape::points;
  wall.file = (folder / "wall.csv").string();
  s.wall.push_back(wall);
  const std::vector<Part> parts = parts_of(s);
  ASSERT_EQ(parts.size(), 2u);
  EXPECT_EQ(parts[1].points, (std::vector<float>{0.5f, 0.25f, 0, 0, 0.75f, 0.5f, 0, 0}));
  s.wall[0].file = (folder / "gone.csv").string();
  EXPECT_TRUE(parts_of(s)[1].points.empty());
}

TEST(ViewStage, PackedNumbersAreTheSameStage) {
  Scene s = box_scene(3);
  s.body.push_back(moved_ball());
  const Stage stage = stage_of(with_defaults(s)), copy = unpacked(packed(stage));
  EXPECT_EQ(packed(copy), packed(stage));
  ASSERT_EQ(copy.parts.size(), 2u);
  EXPECT_EQ(copy.parts[1].kind, Part::Kind::body);
  EXPECT_EQ(copy.parts[1].body, 0);
  EXPECT_EQ(copy.parts[1].triangles, stage.parts[1].triangles);
  EXPECT_FALSE(copy.flat);
  EXPECT_NEAR(copy.start.distance, stage.start.distance, 1e-5);
  EXPECT_EQ(copy.high.x, 2);
}

TEST(ViewActions, TextOfALogIsReadToTheSameNumbers) {
  ActionLog log;
  log.scene = "/tmp/scene.toml";
  log.overrides = {{"time.end", "2"}, {"air", std::nullopt}};
  log.actions.push_back({3, 0.1, Action::Kind::change, {"domain.gravity", "[0.0, -1.5]"}, {}});
  log.actions.push_back(
      {4, 0.1 + 1e-17, Action::Kind::push, {}, {{1.0 / 3, 2, 0}, 0.1, {1, 2e-7, 0}}});
  log.actions.push_back({5, 0.3, Action::Kind::push, {}, {{1, 2, 3}, 0, {1.0 / 7, 0, 0}, 2}});
  log.actions.push_back({9, 0.4, Action::Kind::release, {}, {}});
  const ActionLog read = parse_log(log.text(), "x.toml");
  EXPECT_EQ(read.scene, log.scene);
  EXPECT_EQ(read.overrides, log.overrides);
  ASSERT_EQ(read.actions.size(), log.actions.size());
  for (std::size_t k = 0; k < read.actions.size(); ++k) {
    EXPECT_EQ(read.actions[k].step, log.actions[k].step);
    EXPECT_EQ(read.actions[k].time, log.actions[k].time);
    EXPECT_EQ(read.actions[k].kind, log.actions[k].kind);
    EXPECT_EQ(read.actions[k].change, log.actions[k].change);
    EXPECT_EQ(read.actions[k].push, log.actions[k].push);
  }
}

std::string refusal_of_log(const std::string& text) {
  try {
    parse_log(text, "x.toml");
  } catch (const Error& e) {
    return e.what();
  }
  return "no error in " + text;
}

TEST(ViewActions, LogsThatAreDamagedAreRejected) {
  const auto expect = [](const std::string& text, const std::string& words) {
    const std::string refusal = refusal_of_log(text);
    EXPECT_NE(std::string::npos, refusal.find(words)) << refusal;
  };
  expect("= 3", "x.toml:1:1: error");
  expect("[[action]]\nstep = 1\ntime = 0\nreleased = true\n", "x.toml:1: error: scene is missing");
  const std::string scene = "scene = \"a.toml\"\n", action = scene + "[[action]]\n";
  expect(scene + "acton = 1\n", "x.toml:2: error: unknown key acton");
  expect(scene + "action = 1\n", "action must be tables");
  expect(scene + "override = [\"x\"]\n", "override must be tables");
  expect(action, "step is missing");
  const auto pushed = [&](const std::string& center, const std::string& rest) {
    return action + "step = 1\ntime = 0.1\ncenter = " + center + "\n" + rest;
  };
  EXPECT_EQ(parse_log(pushed("[1, 2, 3]", "radius = 1\npull = [1, 2, 3]"), "x.toml").actions.size(),
            1u);
  expect(pushed("[1, 2]", "radius = 1\npull = [1, 2, 3]"), "center must be three numbers");
  expect(pushed("[1, 2, 3]", "radius = 1\npull = [nan, 2, 3]"), "pull must be a number of at most");
  expect(pushed("[1, 2, 3]", "radius = 1\npull = [1e300, 2, 3]"), "pull must be a number");
  expect(pushed("[1, 2, 3]", "radius = 0\npull = [1, 2, 3]"), "radius must be greater than 0");
  expect(pushed("[1, 2, 3]", "radius = \"r\"\npull = [1, 2, 3]"), "radius must be a number");
  expect(pushed("[1, 2, 3]", "radius = 1\npul = [1, 2, 3]"), "x.toml:7: error: unknown key pul");
  expect(pushed("[1, 2, 3]", "body = 4294967296\npull = [1, 2, 3]"), "body must be a whole number");
  expect(action + "step = -1\ntime = 0\nreleased = true\n", "step must be a whole number from 0");
  expect(action + "step = 1.5\ntime = 0\nreleased = true\n", "step must be a whole number from 0");
  expect(action + "step = 1\ntime = 0\nreleased = false\n", "released must be true");
  expect(action + "step = 1\ntime = 0\nkey = \"air\"\n", "value is missing");
  std::string deep = "a";
  for (int k = 0; k < 100000; ++k) deep += ".a";
  expect(scene + deep + " = 1\n", "x.toml:2:1: error: keys or brackets are nested too deeply");
}

}  // namespace
}  // namespace freshet::view
