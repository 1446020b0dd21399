// SPDX-License-Identifier: MIT
// The cpu backend has the reference backend's bits, forces on walls included: solvers, kernels,
// integrators and wall methods in 2D and 3D, with every instruction set and several numbers of
// threads.
#include <gtest/gtest.h>

#include <cmath>

#include "engine/select.h"
#include "scene/model/expressions.h"
#include "sim/same_bits.h"

namespace freshet::test {
namespace {

constexpr const char* pushed =
    "body_force = [\"5*sin(40*t)\", \"-20*x\"]\n[walls]\nmethod = \"akinci2012\"";

struct Words {
  int dimension;
  const char* solver;  ///< keys of [solver]
  const char* walls;   ///< keys of [domain], and tables of walls
  const char* integrator;
  const char* step = "0.0005";
};

/// A block of fluid that nearly fills a box and moves, so that it touches the walls.
std::string scene_of(const Words& w) {
  const bool flat = w.dimension == 2;
  std::string text = "[domain]\n";
  text += flat ? "max = [1.0, 1.0]\n" : "max = [0.6, 0.6, 0.6]\n";
  text += w.walls;
  text += flat ? "\n[particles]\nspacing = 0.05\njitter = 0.002\n"
               : "\n[particles]\nspacing = 0.075\njitter = 0.002\n";
  const std::string solver = w.solver;
  text += flat ? "[[fluid]]\nmin = [0.0, 0.0]\nmax = [1.0, 0.9]\nvelocity = [2.0, -1.0]\n"
               : "[[fluid]]\nmin = [0.0, 0.0, 0.0]\nmax = [0.6, 0.5, 0.6]\n"
                 "velocity = [2.0, -1.0, 1.0]\n";
  if (solver.find("surface_tension_method") != std::string::npos)
    text += "viscosity = 20.0\nsurface_tension = 2.0\n";
  if (solver.find("surface_tension_method") != std::string::npos &&
      solver.find("akinci2013") != std::string::npos &&
      std::string(w.walls).find("akinci2012") != std::string::npos)
    text += "adhesion = 0.5\n";
  text += "[solver]\n" + std::string(w.solver);
  text += "\n[time]\nend = 1.0\n" +
          (*w.integrator ? "integrator = \"" + std::string(w.integrator) + "\"\n" : std::string());
  text += "step = " + std::string(w.step) + "\n";
  return text;
}

void PrintTo(const Words& w, std::ostream* out) {
  *out << w.dimension << "D " << w.solver << " " << w.walls << " " << w.integrator;
}
class SameBits : public ::testing::TestWithParam<Words> {
 protected:
  void SetUp() override {
    if (GetParam().walls == pushed && !reads_expressions())
      GTEST_SKIP() << "built without muParser";
    if (!has_solver(parse_scene(scene_of(GetParam()), "words.toml").solver.name))
      GTEST_SKIP() << "not compiled in this build";
  }
};

TEST_P(SameBits, AsTheReference) {
  const Outcome reference = expect_same_bits(scene_of(GetParam()), 25);
  double pushed = 0;
  for (const Vector& force : reference.forces)
    for (const double f : force) pushed += std::abs(f);
  const std::string walls = GetParam().walls;
  const bool wall_less =
      walls.find("xy") != std::string::npos || walls.find("open") != std::string::npos;
  EXPECT_EQ(wall_less, !(pushed > 0)) << "walls must bear a force if there are any";
}

TEST_P(SameBits, AfterARestart) { expect_same_bits_after_restart(scene_of(GetParam()), 12, 13); }

constexpr const char* akinci = "[walls]\nmethod = \"akinci2012\"";
constexpr const char* akinci_slips = "[walls]\nmethod = \"akinci2012\"\nslip = \"free_slip\"";
constexpr const char* adami = "[walls]\nmethod = \"adami2012\"";
constexpr const char* adami_slips = "[walls]\nmethod = \"adami2012\"\nslip = \"free_slip\"";
constexpr const char* monaghan = "[walls]\nmethod = \"monaghan2009\"";
constexpr const char* ghost = "[walls]\nmethod = \"ghost\"\nslip = \"no_slip\"";
constexpr const char* ghost_slips = "[walls]\nmethod = \"ghost\"\nslip = \"free_slip\"";
constexpr const char* reflection = "[walls]\nmethod = \"reflection\"\nrestitution = 0.3";
constexpr const char* periodic_x = "periodic = \"x\"\n[walls]\nmethod = \"ghost\"";
constexpr const char* periodic_x_samples = "periodic = \"x\"\n[walls]\nmethod = \"adami2012\"";
constexpr const char* periodic_xy = "periodic = \"xy\"";
constexpr const char* periodic_xyz = "periodic = \"xyz\"";
constexpr const char* mixed =
    "[walls]\nx_min = \"ghost\"\nx_max = \"akinci2012\"\ny_min = \"adami2012\"\n"
    "y_max = \"monaghan2009\"\n[[wall]]\nshape = \"sphere\"\ncenter = [0.5, 0.9]\nradius = 0.2\n"
    "method = \"reflection\"";
constexpr const char* mueller = "name = \"mueller2003\"\nstiffness = 900.0";
constexpr const char* wcsph_cubic = "name = \"wcsph\"\nsound_speed = 30.0";
constexpr const char* wcsph_c2 = "name = \"wcsph\"\nsound_speed = 30.0\nkernel = \"wendland_c2\"";
constexpr const char* wcsph_c6 = "name = \"wcsph\"\nsound_speed = 30.0\nkernel = \"wendland_c6\"";
constexpr const char* fourtakas_cubic =
    "name = \"delta_sph\"\nsound_speed = 30.0\ndensity_diffusion = \"fourtakas2019\"";
constexpr const char* fourtakas_c4 =
    "name = \"delta_sph\"\nsound_speed = 30.0\nkernel = \"wendland_c4\"";
constexpr const char* antuono_c2 =
    "name = \"delta_sph\"\nsound_speed = 30.0\nkernel = \"wendland_c2\"\n"
    "density_diffusion = \"antuono2010\"";
constexpr const char* pcisph = "name = \"pcisph\"";
constexpr const char* iisph = "name = \"iisph\"";
constexpr const char* iisph_c2 = "name = \"iisph\"\nkernel = \"wendland_c2\"";
constexpr const char* dfsph = "name = \"dfsph\"";
constexpr const char* dfsph_c6 =
    "name = \"dfsph\"\nkernel = \"wendland_c6\"\niteration = \"jacobi\"";
constexpr const char* dfsph_hasty = "name = \"dfsph\"\nmax_iterations = 3";  // its steps are halved
constexpr const char* pbf = "name = \"pbf\"";
constexpr const char* adaptive = "\"adaptive\"\nstep_max = 0.001";

INSTANTIATE_TEST_SUITE_P(
    In2D, SameBits,
    ::testing::Values(
        Words{2, mueller, reflection, "leapfrog"}, Words{2, mueller, ghost, "symplectic_euler"},
        Words{2, mueller, periodic_xy, "verlet"}, Words{2, wcsph_cubic, akinci, "symplectic_euler"},
        Words{2, wcsph_c2, adami_slips, "leapfrog"}, Words{2, wcsph_c6, monaghan, "verlet"},
        Words{2, wcsph_cubic, mixed, "symplectic_euler"},
        Words{2, wcsph_c2, periodic_x_samples, "", adaptive},
        Words{2, fourtakas_cubic, ghost_slips, "symplectic_euler"},
        Words{2, fourtakas_c4, akinci_slips, "leapfrog"}, Words{2, antuono_c2, adami, "verlet"},
        Words{2, antuono_c2, periodic_x, "symplectic_euler", adaptive},
        Words{2, fourtakas_cubic, mixed, "leapfrog"}));

INSTANTIATE_TEST_SUITE_P(In3D, SameBits,
                         ::testing::Values(Words{3, mueller, ghost_slips, "leapfrog"},
                                           Words{3, wcsph_cubic, akinci_slips, "symplectic_euler"},
                                           Words{3, wcsph_c6, ghost, "leapfrog"},
                                           Words{3, wcsph_c2, reflection, "verlet", "0.001"},
                                           Words{3, fourtakas_c4, adami, "leapfrog"},
                                           Words{3, antuono_c2, periodic_x, "symplectic_euler"},
                                           Words{3, fourtakas_cubic, monaghan, "verlet"},
                                           Words{3, fourtakas_cubic, periodic_xyz, "", adaptive}));

INSTANTIATE_TEST_SUITE_P(
    SolvedIn2D, SameBits,
    ::testing::Values(Words{2, pcisph, akinci, ""}, Words{2, pcisph, periodic_x, "", adaptive},
                      Words{2, iisph, ghost_slips, ""}, Words{2, iisph_c2, akinci, "", adaptive},
                      Words{2, dfsph, akinci, ""}, Words{2, dfsph, reflection, ""},
                      Words{2, dfsph, periodic_x, ""}, Words{2, dfsph_c6, monaghan, ""},
                      Words{2, dfsph_hasty, akinci_slips, "", "0.004"},
                      Words{2, dfsph_hasty, ghost, "", "\"adaptive\"\nstep_max = 0.004"},
                      Words{2, pbf, akinci, ""}, Words{2, pbf, ghost, ""},
                      Words{2, pbf, periodic_xy, "", adaptive}));

INSTANTIATE_TEST_SUITE_P(SolvedIn3D, SameBits,
                         ::testing::Values(Words{3, pcisph, ghost, ""}, Words{3, iisph, akinci, ""},
                                           Words{3, dfsph, akinci_slips, "", adaptive},
                                           Words{3, dfsph_c6, periodic_xyz, ""},
                                           Words{3, pbf, akinci, ""}));

INSTANTIATE_TEST_SUITE_P(Pushed, SameBits,
                         ::testing::Values(Words{2, wcsph_c2, pushed, "leapfrog"},
                                           Words{2, iisph, pushed, "", adaptive},
                                           Words{2, dfsph_hasty, pushed, "", "0.004"}));

// All forces besides pressure at once.
#define FRESHET_ALL_FORCES                                                                \
  "vorticity_method = \"bender2017\"\nvorticity_transfer = 0.05\n[air]\ndensity = 20.0\n" \
  "drag = \"gissler2017\"\nvelocity = "
#define FRESHET_IMPLICIT "viscosity_method = \"weiler2018\"\n"
#define FRESHET_AKINCI "surface_tension_method = \"akinci2013\"\n"
constexpr const char* wcsph_forces =
    "name = \"wcsph\"\nsound_speed = 30.0\nkernel = \"wendland_c4\"\n" FRESHET_IMPLICIT
        FRESHET_AKINCI FRESHET_ALL_FORCES "[-9.0, 3.0]\n";
constexpr const char* wcsph_forces_3d =
    "name = \"wcsph\"\nsound_speed = 30.0\n"
    "viscosity_method = \"morris1997\"\n" FRESHET_AKINCI FRESHET_ALL_FORCES "[-9.0, 3.0, 4.0]\n";
constexpr const char* delta_forces =
    "name = \"delta_sph\"\nsound_speed = 30.0\n" FRESHET_IMPLICIT FRESHET_AKINCI FRESHET_ALL_FORCES
    "[-9.0, 3.0]\n";
constexpr const char* dfsph_forces =
    "name = \"dfsph\"\n" FRESHET_IMPLICIT FRESHET_AKINCI FRESHET_ALL_FORCES "[-9.0, 3.0]\n";
constexpr const char* dfsph_forces_hasty =
    "name = \"dfsph\"\nmax_iterations = 3\n" FRESHET_IMPLICIT FRESHET_AKINCI FRESHET_ALL_FORCES
    "[-9.0, 3.0]\n";
constexpr const char* dfsph_forces_3d =
    "name = \"dfsph\"\nkernel = \"wendland_c2\"\n" FRESHET_IMPLICIT FRESHET_AKINCI
        FRESHET_ALL_FORCES "[-9.0, 3.0, 4.0]\n";
constexpr const char* delta_curved =
    "name = \"delta_sph\"\nsound_speed = 30.0\nviscosity_method = \"morris1997\"\n"
    "surface_tension_method = \"morris2000\"";
constexpr const char* dfsph_curved = "name = \"dfsph\"\nsurface_tension_method = \"morris2000\"";
constexpr const char* pbf_forces =
    "name = \"pbf\"\nviscosity_method = \"morris1997\"\n" FRESHET_AKINCI FRESHET_ALL_FORCES
    "[-9.0, 3.0]\n";

// Particle shifting, and a moving wall with images beyond periodic ends.
constexpr const char* delta_shifts =
    "name = \"delta_sph\"\nsound_speed = 30.0\nbackground_pressure = 2000.0\n"
    "shifting_method = \"sun2017\"\nviscosity_method = \"morris1997\"";
constexpr const char* dfsph_shifts = "name = \"dfsph\"\nshifting_method = \"sun2017\"";
constexpr const char* delta_lind2012 =
    "name = \"delta_sph\"\nsound_speed = 30.0\nbackground_pressure = 2000.0\n"
    "shifting_method = \"lind2012\"\nviscosity_method = \"morris1997\"";
constexpr const char* iisph_lind2012 = "name = \"iisph\"\nshifting_method = \"lind2012\"";
constexpr const char* delta_adami2013 =
    "name = \"delta_sph\"\nsound_speed = 30.0\nbackground_pressure = 2000.0\n"
    "shifting_method = \"adami2013\"\nviscosity_method = \"morris1997\"";
constexpr const char* wcsph_adami2013 =
    "name = \"wcsph\"\nsound_speed = 30.0\nshifting_method = \"adami2013\"";
constexpr const char* pbf_adami2013 = "name = \"pbf\"\nshifting_method = \"adami2013\"";
constexpr const char* lid =
    "periodic = \"x\"\n[walls]\nmethod = \"adami2012\"\n[[wall]]\nshape = \"plane\"\n"
    "point = [0, -0.05]\nnormal = [0, -1]\nside = \"inside\"\nmethod = \"adami2012\"\n"
    "velocity = [2, 0]\n";
INSTANTIATE_TEST_SUITE_P(Shifted, SameBits,
                         ::testing::Values(Words{2, delta_shifts, lid, "symplectic_euler"},
                                           Words{3, delta_shifts, adami, "leapfrog", adaptive},
                                           Words{2, dfsph_shifts, akinci, "", adaptive},
                                           Words{2, delta_lind2012, lid, "leapfrog"},
                                           Words{3, delta_lind2012, akinci, "verlet", adaptive},
                                           Words{2, iisph_lind2012, periodic_xy, ""},
                                           Words{2, delta_adami2013, lid, "verlet"},
                                           Words{3, delta_adami2013, akinci, "leapfrog", adaptive},
                                           Words{2, wcsph_adami2013, ghost, "symplectic_euler"},
                                           Words{2, pbf_adami2013, periodic_xy, "", adaptive}));

INSTANTIATE_TEST_SUITE_P(
    Forced, SameBits,
    ::testing::Values(Words{2, wcsph_forces, akinci, "symplectic_euler"},
                      Words{2, wcsph_forces, adami, "leapfrog", adaptive},
                      Words{2, wcsph_forces, periodic_x_samples, "verlet"},
                      Words{2, delta_forces, akinci, "leapfrog"},
                      Words{2, dfsph_forces, akinci, "", adaptive},
                      Words{2, dfsph_forces_hasty, akinci_slips, "", "0.004"},
                      Words{2, pbf_forces, akinci, ""}, Words{2, delta_curved, adami, "leapfrog"},
                      Words{2, delta_curved, "[walls]\nmethod = \"open\"", "verlet"},
                      Words{3, dfsph_curved, akinci, "", adaptive},
                      Words{3, wcsph_forces_3d, adami, "symplectic_euler"},
                      Words{3, dfsph_forces_3d, akinci, "", adaptive}));

// The scene has a drop about a thousand domain widths away. Gravity points from there to the domain,
// or the drop would have left.
TEST(FarFlung, HasTheReferencesBits) {
  for (const char* solver : {wcsph_cubic, antuono_c2})
    for (const int dimension : {2, 3}) {
      const bool flat = dimension == 2;
      const std::string text = scene_of({dimension, solver, "[walls]\nmethod = \"open\"", ""});
      Scene scene = parse_scene(text, "far.toml");
      Scene::Fluid drop = scene.fluid[0];
      drop.min = flat ? Vector{1000, -700} : Vector{600, -420, 500};
      drop.max = drop.min;
      for (double& x : drop.max) x += 0.2;
      drop.outside = Outside::clamp;  // not an error; open walls do not move it
      scene.domain.gravity = flat ? Vector{-7, 7} : Vector{-6, 6, -6};
      scene.fluid.push_back(drop);
      const auto state = [&](BackendName backend, int threads) {
        scene.solver.backend = backend;
        Simulation sim(scene, {threads, ""});
        const std::size_t particles = sim.fluid().size();
        for (int k = 0; k < 25; ++k) sim.step();
        EXPECT_EQ(particles, sim.fluid().size());
        return sim.state_sha256();
      };
      const std::string reference = state(BackendName::reference, 1);
      for (const int threads : {2, 1}) EXPECT_EQ(reference, state(BackendName::cpu, threads));
    }
}

}  // namespace
}  // namespace freshet::test
