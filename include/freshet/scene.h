// SPDX-License-Identifier: MIT
#pragma once
#include <cstdint>
#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "freshet/error.h"

namespace freshet {

using Vector = std::vector<double>;        ///< one number per dimension
using Counts = std::vector<std::int64_t>;  ///< one whole number per dimension

enum class Shape { box, lattice };
enum class Outside { error, clamp };
enum class SolverName { mueller2003 };
enum class Scheme { paper, article };
enum class BackendName { cpu, reference };
enum class Search { grid, all_pairs };
enum class NeighborOrder { cell, id };

/// Everything that a simulation needs, in SI units. docs/scene.md has every key with its unit,
/// default and range; the members carry the same names. A scene can be filled in code or loaded.
struct Scene {
  struct Domain {
    Vector min{0, 0}, max;
    Vector gravity{0, -9.81};
  };
  struct Particles {
    double spacing = 0;
    std::optional<double> support_radius, mass;
    double jitter = 0;
    std::int64_t seed = 1;
  };
  struct Fluid {
    Shape shape = Shape::box;
    Vector min, max;  // box
    Vector from;      // lattice
    Counts count;     // lattice
    Vector velocity{0, 0};
    double rest_density = 1000;
    double viscosity = 0.001;
    Outside outside = Outside::error;
  };
  struct Solver {
    SolverName name = SolverName::mueller2003;
    Scheme scheme = Scheme::paper;
    BackendName backend = BackendName::cpu;
    Search search = Search::grid;
    NeighborOrder neighbor_order = NeighborOrder::cell;
    std::optional<double> stiffness, speed_limit;
  };
  struct Walls {
    double restitution = 0.5;
  };
  struct Time {
    double end = 0, step = 0;
  };
  struct Output {
    std::optional<std::int64_t> frame_every_steps, observables_every_steps;
  };
  struct Picture {
    std::int64_t width = 800, height = 600, dot_radius = 5;
  };
  struct Checks {
    std::optional<std::int64_t> out_of_bounds_max;
    std::optional<double> density_mean_min, speed_mean_max, height_mean_max, bright_fraction_min;
  };

  std::string title, description;
  Domain domain;
  Particles particles;
  std::vector<Fluid> fluid;
  Solver solver;
  Walls walls;
  Time time;
  Output output;
  Picture picture;
  Checks checks;

  /// The TOML text that this scene was loaded from, overrides included; empty for one made in code.
  std::string source;
  /// Where each key that was given stands ("fluid[0].count" -> "FILE:LINE:COLUMN" or "--set KEY").
  std::map<std::string, std::string> places;

  int dimension() const { return 2; }
  /// The whole number of fixed steps, round(end/step).
  std::int64_t steps() const;
};

/// An override as `--set KEY=VALUE` gives it: VALUE is TOML, else a string.
using Override = std::pair<std::string, std::string>;

/// Loads and checks a scene.
/// Throws Error (kind scene) with every semantic error at once, or one syntax error alone.
Scene load_scene(const std::filesystem::path& file, const std::vector<Override>& overrides = {});

/// The same from text; `name` stands for the file in messages.
Scene parse_scene(const std::string& text, const std::string& name,
                  const std::vector<Override>& overrides = {});

/// What to override for the same scene with about `particles` particles: every length that belongs
/// to a particle, and with them the time step, shrinks by one factor; blocks and domain stay.
std::vector<Override> at_resolution(const Scene& scene, double particles);

/// What is doubtful in a good scene: lattice errors above 2 %, a time step over its bound, ...
std::vector<Diagnostic> scene_warnings(const Scene& scene);

/// The JSON Schema of scene files, for editors.
std::string scene_schema();
/// The reference of every scene key in Markdown (docs/scene.md).
std::string scene_reference();

}  // namespace freshet
