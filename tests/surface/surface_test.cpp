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
        SurfaceSettings{.cell = 0.3, .radius = 1.5}, SurfaceSettings{.radius = 3.3, .level = 0.2},
        SurfaceSettings{.kernels = SurfaceKernels::anisotropic}})
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

double volume_ratio(const Frame& frame, const SurfaceSettings& settings = {}) {
  return volume_of(surface_of(frame, double(dx), origin, settings)) / particle_volume(frame);
}

TEST(Surface, OfEachPieceHasTheVolumeOfItsParticles) {
  for (int k = 0; k < 20; ++k) EXPECT_NEAR(volume_ratio(cloud(1, 1, unsigned(k))), 1, 0.02);
  EXPECT_NEAR(volume_ratio(fluid_at({0.03f, 0, 0, 0.13f, 0, 0.01f})), 1, 0.02);
  for (const float jitter : {0.0f, 0.1f, 0.2f}) {
    for (const float height : {0.1f, 0.2f})
      EXPECT_NEAR(volume_ratio(slab(3, height, dx, jitter)), 1, 0.02) << height << " " << jitter;
    for (const float side : {0.4f, 0.6f, 0.8f})
      EXPECT_NEAR(volume_ratio(slab(side, side, dx, jitter)), 1, 0.02) << side << " " << jitter;
  }
}

TEST(Surface, OfAShellHasTheVolumeOfItsParticles) {
  const Frame shell = lattice_in(12, dx, 0.1f, [](float x, float y, float z) {
    const float r2 = x * x + y * y + z * z;
    return r2 < 1 && r2 > 0.25f;
  });
  EXPECT_NEAR(volume_ratio(shell), 1, 0.02);
  EXPECT_EQ(faults_of(surface_of(shell, double(dx), origin)), 0);
}

TEST(Surface, LiesAtTheLevelIfAsked) {
  const SurfaceSettings thick{.level = 0.3, .volume = SurfaceVolume::level};
  EXPECT_GT(volume_ratio(slab(3, 0.1f, dx, 0), thick), 1.3);
  const SurfaceSettings level{.volume = SurfaceVolume::level};
  double mean = 0;  // a droplet's volume depends on its place in the grid
  for (int k = 0; k < 50; ++k) mean += volume_ratio(cloud(1, 1, unsigned(k)), level) / 50;
  EXPECT_NEAR(mean, 1, 0.02);
  EXPECT_NEAR(volume_ratio(ball(1, dx, 0.1f), level), 1, 0.02);
  EXPECT_NEAR(volume_ratio(slab(10, 1.2f, dx, 0.1f), level), 1, 0.02);
}

// The thickness of a curtain of one or two particles above a pool, far from its edges.
TEST(Surface, OfAFilmOnAPoolIsAsThickAsItsParticles) {
  for (const float layers : {1.0f, 2.0f})
    for (const double radius : {2.0, 2.5, 3.0})
      for (const float jitter : {0.0f, 0.1f}) {
        const Frame frame = lattice_in(20, dx, jitter, [=](float x, float y, float z) {
          const bool pool = y > 0 && y < 0.8f && std::abs(z) < 1.5f;
          const bool curtain = y > 0.8f && y < 1.9f && z > 0 && z < layers * dx;
          return (pool || curtain) && std::abs(x) < 1.5f;
        });
        double sum = 0;
        int count = 0;
        for (const auto& p : surface_of(frame, double(dx), origin, {.radius = radius}).position) {
          if (!(p[1] > 1.2f && p[1] < 1.6f && std::abs(p[0]) < 1.1f)) continue;
          sum += std::abs(double(p[2] - layers * dx / 2));
          ++count;
        }
        EXPECT_NEAR(2 * sum / count / double(layers * dx), 1, 0.06) << radius << " " << jitter;
      }
}

TEST(Surface, OfAThinFilmHasNoHoles) {
  // A film whose particles are 1.3 spacings apart: its mesh is a sphere's.
  const SurfaceMesh film = surface_of(slab(3, 0.13f, 1.3f * dx, 0.1f), double(dx), origin);
  EXPECT_EQ(int(film.position.size()) - int(film.triangles.size()) / 2, 2);
}

TEST(Surface, HasTheSameBitsForAnyNumberOfThreads) {
  Frame frame = cloud(3000, 1.6f, 5);
  for (std::size_t k = 0; k < frame.v.size(); ++k) frame.v[k] = frame.x[k];
  for (const SurfaceKernels kernels : {SurfaceKernels::isotropic, SurfaceKernels::anisotropic}) {
    const SurfaceSettings settings{.kernels = kernels,
                                   .simplify = simplifies_surfaces() ? 0.05 : 0};
    const SurfaceMesh one = surface_of(frame, double(dx), origin, settings, 1);
    for (const int threads : {2, 4}) {
      const SurfaceMesh more = surface_of(frame, double(dx), origin, settings, threads);
      EXPECT_EQ(one.triangles, more.triangles);
      EXPECT_EQ(one.position, more.position);
      EXPECT_EQ(one.normal, more.normal);
      EXPECT_EQ(one.velocity, more.velocity);
    }
  }
}

/// The root mean square of the heights of the top of a slab, far from its edges [spacings].
double roughness(const Frame& frame, float top, const SurfaceSettings& settings) {
  double sum = 0, sum2 = 0;
  int count = 0;
  for (const auto& p : surface_of(frame, double(dx), origin, settings).position) {
    if (!(p[1] > top - 3 * dx && std::abs(p[0]) < 1.4f && std::abs(p[2]) < 1.4f)) continue;
    const double height = double((p[1] - top) / dx);
    sum += height;
    sum2 += height * height;
    ++count;
  }
  return std::sqrt(sum2 / count - sum / count * sum / count);
}

TEST(Surface, IsFlatterWithAnisotropicKernels) {
  for (const float jitter : {0.1f, 0.2f})
    for (const int smooth : {0, 10}) {
      const Frame frame = slab(4, 1.2f, dx, jitter);
      SurfaceSettings settings{.smooth = smooth};
      const double round = roughness(frame, 1.2f, settings);
      settings.kernels = SurfaceKernels::anisotropic;
      const double expected = smooth == 0 ? 0.6 : 0.85;
      EXPECT_LT(roughness(frame, 1.2f, settings), expected * round) << jitter << " " << smooth;
    }
}

TEST(Surface, HasItsVolumeWithAnisotropicKernels) {
  SurfaceSettings settings{.kernels = SurfaceKernels::anisotropic};
  for (const SurfaceVolume volume : {SurfaceVolume::particles, SurfaceVolume::level})
    for (const float jitter : {0.0f, 0.1f, 0.2f}) {
      settings.volume = volume;
      EXPECT_NEAR(volume_ratio(slab(6, 1.2f, dx, jitter), settings), 1, 0.02) << jitter;
      EXPECT_NEAR(volume_ratio(ball(1, dx, jitter), settings), 1, 0.02) << jitter;
    }
}

TEST(Surface, OfADropletIsRoundWithAnisotropicKernels) {
  const Frame drop = fluid_at({0.03f, 0, 0, 0.13f, 0, 0.01f});
  const SurfaceMesh round = surface_of(drop, double(dx), origin);
  const SurfaceMesh shaped =
      surface_of(drop, double(dx), origin, {.kernels = SurfaceKernels::anisotropic});
  EXPECT_EQ(round.triangles, shaped.triangles);
  EXPECT_EQ(round.position, shaped.position);
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
  expect_error(good, {.simplify = 2}, "option simplify 2: error: it must be from 0 to 1");
  if (!simplifies_surfaces())
    expect_error(good, {.simplify = 0.05},
                 "option simplify 0.05: error: it needs meshoptimizer, and this Freshet was built "
                 "without it; install libmeshoptimizer-dev");
}

TEST(Surface, OfAParticleFarAwayTakesLittleMemory) {
  const SurfaceMesh mesh = surface_of(fluid_at({0, 0, 0, 30000, 30000, 30000}), double(dx), origin);
  EXPECT_LT(mesh.triangles.size(), 300u);
}

}  // namespace
}  // namespace freshet::test
