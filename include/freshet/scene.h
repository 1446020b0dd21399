// SPDX-License-Identifier: MIT
#pragma once
#include <cstdint>
#include <filesystem>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "freshet/error.h"
#include "freshet/time_step.h"

namespace freshet {

using Vector = std::vector<double>;        ///< one number per dimension
using Counts = std::vector<std::int64_t>;  ///< one whole number per dimension

enum class Shape { box, sphere, cylinder, plane, points, mesh, lattice };
enum class Side { inside, outside };
enum class Outside { error, clamp };
enum class StartPressure { zero, hydrostatic };
enum class Axes { none, x, y, xy, z, xz, yz, xyz };  // bit d is axis d
enum class SolverName { mueller2003, wcsph, delta_sph, pcisph, iisph, dfsph, pbf };
enum class Scheme { paper, article };
enum class KernelName { cubic_spline, wendland_c2, wendland_c4, wendland_c6 };
enum class DensityDiffusion { none, fourtakas2019, antuono2010 };
enum class Iteration { jacobi, nesterov };
enum class WallMethod { open, reflection, monaghan2009, ghost, akinci2012, adami2012 };
enum class Slip { free_slip, no_slip };
enum class BackendName { cpu, reference };
enum class Search { grid, all_pairs };
enum class Dots { glow, solid };
enum class ColorBy {
  speed,
  velocity_x,
  velocity_y,
  velocity_z,
  density,
  density_error,
  pressure,
  height,
  id
};
enum class ColorMap { article, water, viridis, inferno, coolwarm };
enum class NeighborOrder { cell, id };
enum class WhenWrong { stop, warn };
enum class DataFormat { vtp, ply, csv, hdf5 };
enum class DataField { velocity, density, pressure, id };
enum class Precision { float32, float16 };

struct LoadedMesh;

/// Everything that a simulation needs, in SI units. docs/scene.md has every key with its unit,
/// default and range; the members carry the same names. A scene can be filled in code or loaded.
struct Scene {
  struct Domain {
    Vector min, max;  // min: the origin if empty
    Vector gravity;   // (0, -9.81) or (0, -9.81, 0) if empty
    std::vector<std::string> body_force;  // [m/s²] beside gravity: functions of x, y, z and t
    Axes periodic = Axes::none;
  };
  struct Particles {
    double spacing = 0;
    std::optional<double> support_radius, mass;
    double jitter = 0;
    std::int64_t seed = 1;
  };
  /// What a fluid fills, or where a wall stands.
  struct Region {
    Shape shape = Shape::box;
    Side side = Side::inside;  // the fluid's side of the surface; a wall's is outside by default
    Vector min, max;           // box
    Vector from;               // lattice
    Counts count;              // lattice
    Vector center;             // sphere (in 2D a disc), cylinder
    double radius = 0;         // sphere, cylinder
    Vector axis;               // cylinder: along its length; any length
    double length = 0;         // cylinder
    Vector point, normal;      // plane: inside is where the normal does not point
    std::string file;          // points: *.ply, *.vtp or *.csv; mesh: *.stl, *.obj or *.ply
    double scale = 1;          // mesh: metres that one unit of the file is
    Vector rotation;     // mesh: about x, then y, then z [degrees], after scaling; none if empty
    Vector translation;  // mesh: at last [m]; none if empty
    std::shared_ptr<const LoadedMesh> loaded;  // mesh: what loading the scene read
  };
  struct Fluid : Region {
    Vector velocity;  // at rest if empty
    double rest_density = 1000;
    double viscosity = 0.001;
    StartPressure pressure = StartPressure::zero;
    Outside outside = Outside::error;
  };
  struct Wall : Region {
    Wall() { side = Side::outside; }
    std::string name;  // "wall[k]" if empty
    std::optional<WallMethod> method;
    Slip slip = Slip::no_slip;
    double restitution = 0.5;
  };
  struct Solver {
    SolverName name = SolverName::mueller2003;
    Scheme scheme = Scheme::paper;
    BackendName backend = BackendName::cpu;
    Search search = Search::grid;
    NeighborOrder neighbor_order = NeighborOrder::cell;
    std::optional<double> stiffness, speed_limit;                          // mueller2003
    KernelName kernel = KernelName::cubic_spline;                          // wcsph, delta_sph
    std::optional<double> sound_speed;                                     // wcsph, delta_sph
    double artificial_viscosity = 0.05;                                    // wcsph, delta_sph
    DensityDiffusion density_diffusion = DensityDiffusion::fourtakas2019;  // delta_sph
    double delta = 0.1;                                                    // delta_sph
    // Of those that solve for the pressure: pcisph, iisph, dfsph, pbf.
    std::optional<double> density_tolerance;  // 0.0001 for dfsph, else 0.001
    double divergence_tolerance = 0.001;      // dfsph
    std::int64_t min_iterations = 1, max_iterations = 100;
    bool warm_start = true;                     // iisph, dfsph
    Iteration iteration = Iteration::nesterov;  // dfsph
    double xsph = 0.01;

    /// Whether the pressure is solved for, so that the density stays what it is.
    bool incompressible() const { return name >= SolverName::pcisph; }
  };
  /// The sides of the domain. One that is not given has `method`; if that is not given either,
  /// reflection for mueller2003 and akinci2012 for the others.
  struct Walls {
    std::optional<WallMethod> method, x_min, x_max, y_min, y_max, z_min, z_max;
    Slip slip = Slip::no_slip;
    double restitution = 0.5;
  };
  struct Time {
    double end = 0;
    double step = 0;        // fixed; unused if adaptive
    bool adaptive = false;  // step = "adaptive"
    std::optional<double> step_max;
    bool retry = true;                     // a step whose solve did not converge: in halves
    std::optional<Integrator> integrator;  // symplectic_euler for wcsph, else leapfrog
  };
  struct Output {
    std::optional<std::int64_t> frame_every_steps, observables_every_steps;
    std::optional<double> frame_every, observables_every;  // [s]
    std::optional<std::int64_t> checkpoint_every_steps;
    std::optional<double> checkpoint_every;         // [s]
    std::vector<DataFormat> data{DataFormat::vtp};  // no data files if empty
    std::vector<DataField> fields{DataField::velocity, DataField::density, DataField::pressure,
                                  DataField::id};  // besides the position
    Precision precision = Precision::float32;
    std::optional<std::int64_t> data_every_steps;  // as the frames if neither is given
    std::optional<double> data_every;              // [s]
  };
  struct Picture {
    std::int64_t width = 800, height = 600;  // [px]
    std::optional<std::int64_t> dot_radius;  // [px]; 2D
    Dots dots = Dots::glow;                  // 2D
    Vector window;                           // x_min, y_min, x_max, y_max; 2D
    ColorBy color_by = ColorBy::speed;
    std::optional<ColorMap> color_map;  // article in 2D, water in 3D
    Vector color_range;                 // least and greatest; of each picture if empty
    std::string background = "night";   // a word, or "#rrggbb"
    bool time_stamp = false, scale_bar = false, color_bar = false;
  };
  /// Where a picture in 3D is seen from; several are key frames.
  struct Camera {
    double time = 0;            // of a key frame
    Vector position;            // in front, to the right and above, if empty
    Vector target;              // the middle of the domain if empty
    double field_of_view = 35;  // [degrees] from the bottom of the picture to its top
    double orbit = 0;           // [degrees/s] about the vertical through the target
  };
  struct Checks {
    std::optional<std::int64_t> out_of_bounds_max;
    std::optional<double> density_mean_min, speed_mean_max, height_mean_max, bright_fraction_min;
    WhenWrong when_wrong = WhenWrong::stop;
  };

  std::string title, description;
  Domain domain;
  Particles particles;
  std::vector<Fluid> fluid;
  std::vector<Wall> wall;
  Solver solver;
  Walls walls;
  Time time;
  Output output;
  Picture picture;
  std::vector<Camera> camera;
  Checks checks;

  /// The TOML text that this scene was loaded from, overrides included; empty for one made in code.
  std::string source;
  /// Where each key that was given stands ("fluid[0].count" -> "FILE:LINE:COLUMN" or "--set KEY").
  std::map<std::string, std::string> places;

  int dimension() const { return int(domain.max.size()); }  ///< 2 or 3
  /// The whole number of fixed steps, round(end/step); of an adaptive run end/step_max, a guess.
  std::int64_t steps() const;
  /// Of side d·2 + (0: min, 1: max); `reflection` and the like also where the axis is periodic.
  WallMethod side_method(int side) const;
  WallMethod wall_method(std::size_t k) const;
  bool periodic(int axis) const { return int(domain.periodic) >> axis & 1; }
  Integrator integrator() const;
  /// "x_min" ... "z_max", then the walls' names: what forces are reported by.
  std::vector<std::string> wall_names() const;
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
