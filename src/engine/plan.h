// SPDX-License-Identifier: MIT
/// The numbers that an engine is made from: no scene, no instruction set. sim/plan_of_scene.cpp
/// makes them from a scene. Vectors have three components; in 2D the third is 0.
#pragma once
#include <array>
#include <functional>
#include <limits>
#include <vector>

#include "boundary/solid_kind.h"
#include "core/inlet_plan.h"
#include "core/sample.h"
#include "freshet/methods.h"
#include "freshet/time_step.h"
#include "solvers/solve.h"

namespace freshet {

class Bodies;

/// The surface of a box, ball, cylinder or half space: boundary/solid.h explains the members.
struct SolidPlan {
  SolidKind kind = SolidKind::box;
  Triple center{}, half{}, axis{};
  double radius = 0, half_length = 0;
  bool fluid_inside = false;
};

/// A shape that reflects particles.
struct ReflectorPlan {
  SolidPlan solid;
  double restitution;
  int wall;  ///< index of the wall for its force
};

/// Periodic or mirror images: boundary/copy_rule.h explains the members.
struct CopyRulePlan {
  Triple point{}, normal{}, shift{};
  bool mirror = true, no_slip = false;
  int axis = 0;
  int wall = -1;  ///< index of the wall for its force; -1: none
};

/// A flat opening that counts particles: boundary/opening.h explains the members.
struct OpeningPlan {
  Triple center{}, direction{}, across{}, up{};
  double half_width, half_height, radius;
};

/// A liquid. The densest one has the plan's rest density.
struct LiquidPlan {
  double rest_density;     ///< [kg/m^3]
  double viscosity;        ///< dynamic [Pa s]
  double surface_tension;  ///< [N/m]
  double cohesion;         ///< gamma of Akinci 2013 [m/s^2]
  double adhesion;         ///< beta of Akinci 2013 [m/s^2]
};

/// Forces beside pressure, gravity and walls.
struct ForcesPlan {
  ViscosityMethod viscosity = ViscosityMethod::artificial;  ///< artificial: none of these forces
  SurfaceTensionMethod tension = SurfaceTensionMethod::none;
  ShiftingMethod shifting = ShiftingMethod::none;
  VorticityMethod vorticity = VorticityMethod::none;
  Drag drag = Drag::none;
  double vorticity_transfer = 0, vorticity_inertia = 0;  ///< nu_t, Theta of Bender 2017
  Iterations implicit{};                                 ///< of Weiler 2018
  double air_density = 0, air_viscosity = 0;
  Triple air_velocity{};
  double W_spacing = 0;   ///< W at a distance of one spacing [1/m^D]
  double mean_depth = 0;  ///< mean distance from a plane through the centre under W [m]
  double neighbors = 0;   ///< number of neighbours in a resting lattice
  bool no_walls = false;  ///< no wall can take up momentum
  bool any() const {
    return viscosity != ViscosityMethod::artificial || tension != SurfaceTensionMethod::none ||
           shifting != ShiftingMethod::none || vorticity != VorticityMethod::none ||
           drag != Drag::none;
  }
};

/// Spray, foam and bubbles: Scene::Whitewater explains the numbers.
struct WhitewaterPlan {
  bool active = false;
  double trapped_air = 0, wave_crest = 0, turbulence = 0;
  std::array<double, 2> trapped_limits{}, crest_limits{}, turbulence_limits{}, speed_limits{};
  double life_min = 0, life_max = 0;
  double buoyancy = 0, rise_speed = 0;
  double neighbors = 0;  ///< number of neighbours in a resting lattice
  std::int64_t most = 0;
  std::uint64_t seed = 0;
};

/// The input of an engine. SI units. Positions are relative to `origin`, except those of bodies and
/// body particles, which are the scene's.
struct EnginePlan {
  int dimension = 2, threads = 1;
  SolverName solver = SolverName::mueller2003;
  bool incompressible = false;   ///< solves for the pressure
  bool predicts_places = false;  ///< moves the particles before it solves
  KernelName kernel = KernelName::cubic_spline;
  Integrator integrator = Integrator::leapfrog;
  Search search = Search::grid;
  NeighborOrder neighbor_order = NeighborOrder::cell;
  bool article = false;  ///< the article's step and constants

  // Particles
  double support = 0;       ///< support radius [m]
  double skin = 0;          ///< by which lists that serve several steps reach farther [m]; or 0
  double h = 0;             ///< the paper's h: half the support, mueller2003: the support [m]
  double spacing = 0;       ///< [m]
  double mass = 0;          ///< of the densest liquid [kg/m^(3-D)]
  double lattice_sum = 1;   ///< divisor of density sums
  double rest_density = 0;  ///< of the densest liquid [kg/m^3]
  double lightness = 1;     ///< maximum over minimum rest density of the liquids
  double viscosity = 0;     ///< maximum kinematic viscosity times rest_density [Pa s]
  std::vector<LiquidPlan> liquids;

  // Pressure
  double sound_speed = 0;  ///< of the densest liquid; a scale for pressure solvers [m/s]
  double stiffness = 0;    ///< k of mueller2003 [m^2/s^2]
  double speed_limit = std::numeric_limits<double>::infinity();  ///< article [m/s]
  double background_pressure = 0;                                ///< [Pa]
  double artificial_viscosity = 0, density_diffusion = 0;        ///< alpha, delta
  double acoustic_damping = 0;
  bool antuono2010 = false;  ///< diffusion of Antuono 2010, else of Fourtakas 2019
  double own_viscosity = 0;  ///< maximum kinematic viscosity that a pressure solver sums itself
  double xsph = 0, xsph_time = 0;  ///< share, and the time in which [s]; 0: ten steps
  double lattice_response = 0, lattice_stiffness = 0, surface_deficit = 0;  // lattice_sum.h
  bool warm_start = false, accelerated = false, gradual = false;
  Iterations density{}, divergence{}, divergence_at_rest{};

  // Domain
  Triple origin{};  ///< in the scene [m]
  Triple min{}, max{}, gravity{};
  std::array<bool, 3> periodic{};
  unsigned open_sides = 0;  ///< bit 2k: min, 2k + 1: max of axis k; none of a periodic axis
  /// An acceleration b(x, t) added to gravity [m/s^2]; empty: none. One thread calls it.
  std::function<void(const double (&x)[3], double t, double* b)> body_force;
  bool body_force_varies = false;  ///< whether b depends on x

  // Walls, by their index in Scene::wall_names()
  struct Wall {
    bool no_slip;
    Triple slide;  ///< tangential velocity of its surface [m/s]
  };
  std::vector<Wall> walls;
  unsigned reflecting_sides = 0;  ///< bit 2k: min, 2k + 1: max of axis k
  double restitution = 0;         ///< of the sides
  std::vector<ReflectorPlan> reflectors;
  std::vector<CopyRulePlan> copies;

  // Flows
  std::vector<InletPlan> inlets;
  std::vector<SolidPlan> outlets;
  std::vector<OpeningPlan> counters;

  // Bodies
  Bodies* bodies = nullptr;     ///< outlives the engine; null without bodies
  bool layered_bodies = false;  ///< sampled for adami2012, else for akinci2012
  std::vector<bool> body_no_slip;

  ForcesPlan forces;
  WhitewaterPlan whitewater;
  Sample sample;
};

}  // namespace freshet
