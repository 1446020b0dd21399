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
#include "freshet/methods.h"
#include "freshet/solver_method.h"
#include "freshet/time_step.h"
#include "freshet/vector.h"

namespace freshet {

enum class Shape { box, sphere, cylinder, plane, points, mesh, lattice };
enum class Side { inside, outside };
enum class Outside { error, clamp };
enum class StartPressure { zero, hydrostatic };
enum class Axes { none, x, y, xy, z, xz, yz, xyz };  // bit d is axis d
enum class Dots { glow, solid };
enum class ProbeKind { point, line, plane, surface, wall };
enum class ColorBy {
  speed,
  velocity_x,
  velocity_y,
  velocity_z,
  density,
  density_error,
  pressure,
  height,
  id,
  liquid
};
enum class ColorMap { article, water, viridis, inferno, coolwarm };
enum class WhenWrong { stop, warn };
enum class DataFormat { vtp, ply, csv, hdf5 };
enum class DataField { velocity, density, pressure, id };
enum class Precision { float32, float16 };
enum class BodyMotion { fixed, moved, free };
enum class Interpolation { smooth, linear };

struct LoadedMesh;

/// Everything that a simulation needs, in SI units. docs/scene.md has every key with its unit,
/// default and range; the members carry the same names. A scene can be filled in code or loaded.
struct Scene {
  struct Domain {
    Vector min, max;                      // min: the origin if empty
    Vector gravity;                       // (0, -9.81) or (0, -9.81, 0) if empty
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
    Vector velocity;                          // at rest if empty
    std::vector<std::string> velocity_field;  // [m/s] instead: functions of x, y and z
    double rest_density = 1000;
    double viscosity = 0.001;
    std::string color;  // "#rrggbb", for pictures by liquid; one of a list if empty
    std::optional<double> surface_tension;
    double adhesion = 0;
    StartPressure pressure = StartPressure::zero;
    Outside outside = Outside::error;
  };
  struct Wall : Region {
    Wall() { side = Side::outside; }
    std::string name;  // "wall[k]" if empty
    std::optional<WallMethod> method;
    Slip slip = Slip::no_slip;
    Vector velocity;  // of its surface, which slides along itself; at rest if empty
    double restitution = 0.5;
  };
  /// A flat piece: in 2D a slit of `width`, in 3D a disc or a rectangle.
  struct Opening {
    std::string name;
    Vector center, direction;             // direction: across the piece; any length
    std::optional<double> radius;         // of a disc
    std::optional<double> width, height;  // of a slit or a rectangle
    Vector up;  // of a rectangle: roughly along its height; y if empty, or z where that is across
  };
  /// Where liquid comes in; "inlet[k]" if it has no name.
  struct Inlet : Opening {
    std::optional<double> speed, flow_rate;  // one of them
    double start = 0;
    std::optional<double> stop;  // never if empty
    std::string recycle;         // an outlet: what leaves there comes in again here
    double rest_density = 1000;
    double viscosity = 0.001;
    std::string color;  // as a fluid's
  };
  /// Where liquid leaves; "outlet[k]" if it has no name.
  struct Outlet : Region {
    std::string name;
  };
  /// Counts what goes through a piece of a plane, or the whole plane; "counter[k]" if nameless.
  struct Counter : Opening {};
  /// A rigid body: where it stands at the start, and what moves it.
  struct Body : Region {
    Body() { side = Side::outside; }
    struct Key {
      double time = 0;     // [s]
      Vector translation;  // from the start [m]; none if empty
      double angle = 0;    // [degrees]
    };
    std::string name;  // "body[k]" if empty
    BodyMotion motion = BodyMotion::fixed;
    Slip slip = Slip::no_slip;
    // moved: from its place at the start, by functions of t, key frames, or those of a file
    std::vector<std::string> position;  // [m]
    std::string angle;                  // [degrees]
    std::vector<Key> key;
    std::string path;  // *.csv
    Interpolation interpolation = Interpolation::smooth;
    Vector pivot;      // what it turns about; its centre of mass if empty
    Vector turn_axis;  // z if empty
    // free
    std::optional<double> density, mass;  // [kg/m^D], [kg; kg/m in 2D]
    Vector velocity;                      // at the start; at rest if empty
    double angular_velocity = 0;          // about turn_axis [rad/s]
    double restitution = 0.3, friction = 0.5;
  };
  /// A hinge.
  struct Joint {
    std::string body, other;                          // names; the world if `other` is empty
    Vector point, axis;                               // at the start; axis: z if empty
    std::optional<double> motor_speed, motor_torque;  // [rad/s], [N m; N in 2D]
  };
  struct Solver {
    SolverName name = SolverName::mueller2003;
    Scheme scheme = Scheme::paper;
    BackendName backend = BackendName::cpu;
    Search search = Search::grid;
    NeighborOrder neighbor_order = NeighborOrder::cell;
    std::optional<double> stiffness, speed_limit;       // mueller2003
    KernelName kernel = KernelName::cubic_spline;       // wcsph, delta_sph
    std::optional<double> sound_speed;                  // wcsph, delta_sph
    std::optional<double> artificial_viscosity;         // wcsph, delta_sph
    std::optional<DensityDiffusion> density_diffusion;  // delta_sph
    double delta = 0.1;                                 // delta_sph
    double background_pressure = 0;                     // wcsph, delta_sph
    // Of those that solve for the pressure: pcisph, iisph, dfsph, pbf.
    std::optional<double> density_tolerance;  // 0.0001 for dfsph, else 0.001
    double divergence_tolerance = 0.001;      // dfsph
    std::int64_t min_iterations = 1, max_iterations = 100;
    bool warm_start = true;                     // iisph, dfsph
    Iteration iteration = Iteration::nesterov;  // dfsph
    double xsph = 0.01;
    // Of all but mueller2003. See Scene::viscosity_method() for the one that is not given.
    std::optional<ViscosityMethod> viscosity_method;
    double viscosity_tolerance = 0.001;           // weiler2018
    std::int64_t viscosity_max_iterations = 200;  // weiler2018
    SurfaceTensionMethod surface_tension_method = SurfaceTensionMethod::none;
    ShiftingMethod shifting_method = ShiftingMethod::none;
    VorticityMethod vorticity_method = VorticityMethod::none;
    std::optional<double> vorticity_transfer, vorticity_inertia;  // bender2017
  };
  /// What the liquid flies through.
  struct Air {
    Drag drag = Drag::none;
    Vector velocity;  // at rest if empty
    double density = 1.2, viscosity = 1.8e-5;
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
  /// Where the fluid is asked while it flows.
  struct Probe {
    std::string name;  // of its table, probes/NAME.csv; "probe_k" if empty
    ProbeKind kind = ProbeKind::point;
    Vector at;                    // point
    Vector from, to;              // line, surface; plane, wall: opposite corners
    std::int64_t count = 2;       // line: places, both ends included
    std::optional<double> apart;  // [m]; plane: its places; the particles' spacing if not given
    std::string body;             // that carries it; none if empty
    std::optional<double> every;  // [s]; as the observables if not given
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
  std::vector<Inlet> inlet;
  std::vector<Outlet> outlet;
  std::vector<Counter> counter;
  std::vector<Probe> probe;
  std::vector<Body> body;
  std::vector<Joint> joint;
  Solver solver;
  Air air;
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
  const SolverMethod& method() const { return method_of(solver.name); }
  /// Whether the teaching article's own step and constants are used: mueller2003 with
  /// solver.scheme = "article".
  bool is_article() const {
    return method().reads("solver.scheme") && solver.scheme == Scheme::article;
  }
  /// Fluids that are alike, and what inlets bring, are of one liquid.
  struct Liquid {
    double rest_density, viscosity;
    std::string color;
    bool operator==(const Liquid&) const = default;
  };
  /// In the order of the fluids, then the inlets, that are the first of them.
  std::vector<Liquid> liquids() const;
  /// The place of the k-th fluid's liquid among them.
  int liquid_of(std::size_t k) const;
  /// As given; else fourtakas2019, which knows one liquid's weight, or antuono2010 for several.
  DensityDiffusion density_diffusion() const;
  /// The whole number of fixed steps, round(end/step); of an adaptive run end/step_max, a guess.
  std::int64_t steps() const;
  /// Of side d·2 + (0: min, 1: max); `reflection` and the like also where the axis is periodic.
  WallMethod side_method(int side) const;
  WallMethod wall_method(std::size_t k) const;
  bool periodic(int axis) const { return int(domain.periodic) >> axis & 1; }
  Integrator integrator() const;
  /// As given; else artificial for wcsph and delta_sph, monaghan2005 for the others.
  ViscosityMethod viscosity_method() const;
  /// "x_min" ... "z_max", then the walls' names: what forces are reported by.
  std::vector<std::string> wall_names() const;
  /// Whether particles come or go.
  bool has_flows() const { return !inlet.empty() || !outlet.empty(); }
  /// The names of inlets, then outlets, then counters: what flows are reported by.
  std::vector<std::string> flow_names() const;
  std::string body_name(std::size_t k) const;
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
/// to a particle, and with them the time step, shrinks by one factor; blocks and domain stay. Where
/// there are inlets, so many are there at the most.
std::vector<Override> at_resolution(const Scene& scene, double particles);

/// What is doubtful in a good scene: lattice errors above 2 %, a time step over its bound, ...
std::vector<Diagnostic> scene_warnings(const Scene& scene);

}  // namespace freshet
