// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include <limits>

#include "surface/fluids.h"

namespace freshet::test {
namespace {

constexpr std::array<double, 3> origin{0, 0, 0};
constexpr double pi = 3.14159265358979;
constexpr float dx = 0.1f;

double particle_volume(const Frame& frame) { return double(frame.size()) * double(dx * dx * dx); }

TEST(Surface, IsClosedAndManifold) {
  for (const SurfaceSettings& s :
       {SurfaceSettings{}, SurfaceSettings{.cell = 1, .smooth = 0},
        SurfaceSettings{.cell = 0.3, .radius = 1.5}, SurfaceSettings{.radius = 3.3, .level = 0.2}})
    for (const Frame& frame :
         {cloud(300, 1, 1), cloud(300, 2, 2), cloud(2000, 1.5, 3), ball(0.5, dx, 0.2f),
          slab(1, 0.1f, dx, 0), fluid_at({0.01f, 0, 0}), fluid_at({0, 0, 0, 0.13f, 0.02f, 0}),
          fluid_at({0, 0, 0, 0.25f, 0, 0}), fluid_at({0, 0, 0, 0, 0, 0})}) {
      const SurfaceMesh mesh = surface_of(frame, double(dx), origin, s);
      EXPECT_GT(mesh.triangles.size(), 0u);
      EXPECT_EQ(mesh.position.size(), mesh.normal.size());
      EXPECT_EQ(mesh.position.size(), mesh.velocity.size());
      EXPECT_EQ(faults_of(mesh), 0) << frame.size() << " particles, cell " << s.cell;
      EXPECT_GT(volume_of(mesh), 0);
    }
}

TEST(Surface, OfABallHasItsVolumeAndArea) {
  for (const float radius : {0.5f, 1.0f, 1.73f})
    for (const float jitter : {0.0f, 0.1f}) {
      const Frame frame = ball(radius, dx, jitter);
      const SurfaceMesh mesh = surface_of(frame, double(dx), origin);
      const double volume = particle_volume(frame);
      const double area = std::cbrt(36 * pi * volume * volume);
      EXPECT_NEAR(volume_of(mesh) / volume, 1, 0.02) << radius << " " << jitter;
      EXPECT_NEAR(area_of(mesh) / area, 1, 0.02) << radius << " " << jitter;
    }
}

TEST(Surface, OfASlabHasItsVolumeAndArea) {
  for (const float jitter : {0.0f, 0.1f}) {
    const Frame frame = slab(10, 1.2f, dx, jitter);
    const SurfaceMesh mesh = surface_of(frame, double(dx), origin);
    EXPECT_NEAR(volume_of(mesh) / (10 * 10 * 1.2), 1, 0.02) << jitter;
    EXPECT_NEAR(area_of(mesh) / (2 * 10 * 10 + 4 * 10 * 1.2), 1, 0.02) << jitter;
  }
}

TEST(Surface, KeepsDropletsAndFilms) {
  const auto volume = [](const Frame& frame) {
    return volume_of(surface_of(frame, double(dx), origin)) / particle_volume(frame);
  };
  double mean = 0;  // a droplet's volume depends on its place in the grid
  for (int k = 0; k < 50; ++k) {
    const Frame drop = cloud(1, 1, unsigned(k));
    EXPECT_NEAR(volume(drop), 1, 0.15);
    mean += volume(drop) / 50;
  }
  EXPECT_NEAR(mean, 1, 0.02);
  EXPECT_NEAR(volume(fluid_at({0.03f, 0, 0, 0.13f, 0, 0.01f})), 1, 0.15);
  EXPECT_NEAR(volume(slab(3, 0.1f, dx, 0.1f)), 1, 0.2);
  EXPECT_NEAR(volume(slab(3, 0.2f, dx, 0.1f)), 1, 0.05);
  // A film whose particles are 1.3 spacings apart has no holes: its mesh is a sphere's.
  const SurfaceMesh film = surface_of(slab(3, 0.13f, 1.3f * dx, 0.1f), double(dx), origin);
  EXPECT_EQ(int(film.position.size()) - int(film.triangles.size()) / 2, 2);
}

TEST(Surface, HasTheSameBitsForAnyNumberOfThreads) {
  Frame frame = cloud(3000, 1.6f, 5);
  for (std::size_t k = 0; k < frame.v.size(); ++k) frame.v[k] = frame.x[k];
  const SurfaceMesh one = surface_of(frame, double(dx), origin, {}, 1);
  for (const int threads : {2, 4}) {
    const SurfaceMesh more = surface_of(frame, double(dx), origin, {}, threads);
    EXPECT_EQ(one.triangles, more.triangles);
    EXPECT_EQ(one.position, more.position);
    EXPECT_EQ(one.normal, more.normal);
    EXPECT_EQ(one.velocity, more.velocity);
  }
}

TEST(Surface, HasNormalsOutOfTheFluidAndItsVelocity) {
  Frame frame = ball(1, dx, 0.1f);
  for (std::size_t i = 0; i < frame.size(); ++i) {  // a turn about z and a motion along it
    frame.v[3 * i] = -frame.x[3 * i + 1];
    frame.v[3 * i + 1] = frame.x[3 * i];
    frame.v[3 * i + 2] = 3;
  }
  const SurfaceMesh mesh = surface_of(frame, double(dx), origin);
  double error = 0;
  for (std::size_t k = 0; k < mesh.position.size(); ++k) {
    const auto &x = mesh.position[k], &n = mesh.normal[k], &v = mesh.velocity[k];
    EXPECT_NEAR(std::hypot(n[0], n[1], n[2]), 1, 1e-5);
    EXPECT_GT(x[0] * n[0] + x[1] * n[1] + x[2] * n[2], 0.8f);
    error = std::max({error, std::abs(double(v[0] + x[1])), std::abs(double(v[1] - x[0])),
                      std::abs(double(v[2] - 3))});
  }
  EXPECT_LT(error, 0.15);  // the particles are inside the surface: half a spacing, and jitter
}

TEST(Surface, DoesNotDependOnThePlaceOfTheDomain) {
  const Frame near = ball(0.5f, dx, 0);
  Frame far = near;
  for (float& x : far.x) x += 4096;  // floats there are 1/2048 m apart
  const SurfaceMesh a = surface_of(near, double(dx), origin);
  const SurfaceMesh b = surface_of(far, double(dx), {4096, 4096, 4096});
  EXPECT_NEAR(volume_of(a), volume_of(b), 0.01 * volume_of(a));
  EXPECT_EQ(faults_of(b), 0);
}

TEST(Surface, OfNoParticlesIsEmpty) {
  const SurfaceMesh mesh = surface_of(fluid_at({}), double(dx), origin);
  EXPECT_TRUE(mesh.position.empty());
  EXPECT_TRUE(mesh.triangles.empty());
  EXPECT_EQ(volume_of(mesh), 0);
}

TEST(Surface, RejectsWhatHasNone) {
  const auto expect_error = [](const Frame& frame, const SurfaceSettings& settings,
                               const std::string& words) {
    try {
      surface_of(frame, double(dx), origin, settings);
      ADD_FAILURE() << "no error: " << words;
    } catch (const Error& e) {
      EXPECT_EQ(e.kind(), Error::Kind::scene);
      EXPECT_NE(std::string(e.what()).find(words), std::string::npos) << e.what();
    }
  };
  const Frame good = fluid_at({0, 0, 0, 1, 1, 1});
  Frame flat = good;
  flat.dimension = 2;
  expect_error(flat, {}, "this frame is in 2D; a surface needs a run in 3D");
  Frame torn = good;
  torn.x[4] = std::numeric_limits<float>::quiet_NaN();
  expect_error(torn, {}, "particle 1 is at (1, nan, 1) m");
  torn.x[4] = 1e9f;
  expect_error(torn, {}, "particle 1 is at (1, 1e+09, 1) m");
  expect_error(good, {.cell = 0}, "option cell 0: error: it must be from 0.1 to 2");
  expect_error(good, {.radius = std::nan("")}, "option radius nan");
  expect_error(good, {.cell = 1.1}, "option cell 1.1: error: it must be at most half of `radius`");
  expect_error(good, {.level = 1}, "option level 1");
  expect_error(good, {.smooth = -1}, "option smooth -1");
}

TEST(Surface, OfAParticleFarAwayTakesLittleMemory) {
  const SurfaceMesh mesh = surface_of(fluid_at({0, 0, 0, 30000, 30000, 30000}), double(dx), origin);
  EXPECT_LT(mesh.triangles.size(), 300u);
}

}  // namespace
}  // namespace freshet::test
