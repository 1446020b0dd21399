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
#include "freshet/solver_method.h"
#include "freshet/solver_settings.h"
#include "freshet/surface_settings.h"
#include "freshet/time_step.h"
#include "freshet/vector.h"

namespace freshet {

enum class Shape { box, sphere, cylinder, plane, points, mesh, polygon, lattice };
enum class Side { inside, outside };
enum class Outside { error, clamp };
enum class StartPressure { zero, hydrostatic };
enum class Axes { none, x, y, xy, z, xz, yz, xyz };  // bit d is axis d
enum class Dots { glow, solid };
enum class PictureStyle { balls, water };
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
enum class ColorScale { run, picture };
enum class ColorMap { article, water, viridis, inferno, coolwarm };
enum class WhenWrong { stop, warn };
enum class DataFormat { vtp, ply, csv, hdf5, bgeo };
enum class DataField { velocity, density, pressure, id };
enum class Precision { float32, float16 };
enum class BodyMotion { fixed, moved, free };
/// A translation along an axis of space, or a rotation about it.
enum class Freedom { x, y, z, rotation_x, rotation_y, rotation_z };
enum class Interpolation { smooth, linear };

struct LoadedMesh;

/// Spray, foam and bubbles, which the fluid moves and which do not act on it.
struct WhitewaterSettings {
  double trapped_air = 1, wave_crest = 1, turbulence = 0;  // births per particles.spacing of path
  // low, high; by the scene if empty
  Vector trapped_air_limits, wave_crest_limits, turbulence_limits, speed_limits;
  Vector lifetime{2, 5};                      // of foam: minimum, maximum [s]
  double buoyancy = 2, rise_speed = 0.25;     // of bubbles
  std::optional<std::int64_t> max_particles;  // three times the fluid's if not set
  std::int64_t seed = 0;
};

/// The input of a simulation, in SI units. docs/scene.md documents every key with its unit, default
/// and range; members and keys have the same names. A scene is loaded from TOML or filled in code.
struct Scene {
  struct Domain {
    Vector min, max;                      // min: the origin if empty
    Vector gravity;                       // (0, -9.81) or (0, -9.81, 0) if empty
    std::vector<std::string> body_force;  // [m/s²], added to gravity: functions of x, y, z and t
    Axes periodic = Axes::none;
  };
  struct Particles {
    double spacing = 0;
    std::optional<double> support_radius, mass;
    double jitter = 0;
    std::int64_t seed = 1;
  };
  /// The region of a fluid, wall, outlet or body.
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
    // points and polygon: *.ply, *.vtp or *.csv; mesh: *.stl, *.obj or *.ply
    std::string file;
    std::vector<Vector> points;  // polygon: corners, in either direction
    // polygon: the corners are a line, and a horizontal base at this height closes it [m]
    std::optional<double> base;
    double scale = 1;  // mesh, polygon: metres per unit of the file
    // box: about its centre; mesh, polygon: about the origin, after scaling [degrees]. In 2D one
    // number, in 3D about x, then y, then z. None if empty
    Vector rotation;
    Vector translation;                        // mesh, polygon: after rotation [m]; none if empty
    std::shared_ptr<const LoadedMesh> loaded;  // mesh, polygon, rotated box: with the defaults
  };
  struct Fluid : Region {
    Vector velocity;                          // at rest if empty
    std::vector<std::string> velocity_field;  // [m/s], replaces velocity: functions of x, y and z
    std::string pressure_field;               // [Pa], replaces pressure: a function of x, y and z
    // Height of the free surface [m]: a function of x, in 3D of x and z. The fluid is the part of
    // the shape below it. No surface if empty
    std::string surface;
    // Starts from a frame of another run: its folder, or one of its data files. The defaults set
    // `shape` to points and `file` to the data file.
    std::string from_run;
    std::optional<double> time;          // of the frame [s]; the last frame if neither is set
    std::optional<std::int64_t> frame;   // its number
    std::optional<std::int64_t> liquid;  // which of the run's liquids; required if it has several
    double rest_density = 1000;
    double viscosity = 0.001;
    std::string color;  // "#rrggbb", for color_by = "liquid"; a default palette if empty
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
    Vector velocity;  // tangential velocity of the surface; at rest if empty
    double restitution = 0.5;
  };
  /// A flat opening: in 2D a slit of `width`, in 3D a disc or a rectangle.
  struct Opening {
    std::string name;
    Vector center, direction;             // direction: along the normal; any length
    std::optional<double> radius;         // disc
    std::optional<double> width, height;  // slit or rectangle
    Vector up;  // rectangle: roughly along its height; if empty y, or z where y is the normal
  };
  /// Emits liquid. The name defaults to "inlet[k]".
  struct Inlet : Opening {
    std::optional<double> speed, flow_rate;  // exactly one is set
    double start = 0;
    std::optional<double> stop;  // never if empty
    std::string recycle;         // name of an outlet whose particles this inlet emits again
    std::optional<double> rest_density, viscosity;  // of Scene::inlet_liquid() if not set
    std::string color;                              // see Fluid::color
  };
  /// Removes the liquid that enters its region. The name defaults to "outlet[k]".
  struct Outlet : Region {
    std::string name;
  };
  /// Counts the particles that cross a part of a plane or a whole plane. The name defaults to
  /// "counter[k]".
  struct Counter : Opening {};
  /// A rigid body: its region at the start and its motion.
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
    // moved: relative to the start, by functions of t, key frames, or the key frames of a file
    std::vector<std::string> position;  // [m]
    std::string angle;                  // [degrees]
    std::vector<Key> key;
    std::string path;  // *.csv
    Interpolation interpolation = Interpolation::smooth;
    Vector pivot;      // centre of rotation [m]; the centre of mass if empty
    Vector turn_axis;  // z if empty
    // free
    std::optional<double> density, mass;  // [kg/m^3], [kg; kg/m in 2D]
    Vector center_of_mass;                // at the start [m]; of an even density if empty
    // about the centre of mass at the start [kg m²; kg m²/m in 2D]: zz in 2D, xx, yy, zz in 3D, and
    // perhaps xy, xz, yz; of an even density if empty
    Vector inertia;
    std::vector<Freedom> lock;    // does not move along or about these
    Vector velocity;              // at the start; at rest if empty
    double angular_velocity = 0;  // about turn_axis [rad/s]
    double restitution = 0.3, friction = 0.5;
  };
  /// A hinge.
  struct Joint {
    std::string body, other;                          // names; the world if `other` is empty
    Vector point, axis;                               // at the start; axis: z if empty
    std::optional<double> motor_speed, motor_torque;  // [rad/s], [N m; N in 2D]
  };
  using Solver = SolverSettings;
  /// The air around the liquid: density [kg/m³], dynamic viscosity [Pa s], wind [m/s].
  struct Air {
    Drag drag = Drag::none;
    Vector velocity;  // at rest if empty
    double density = 1.2, viscosity = 1.8e-5;
  };
  using Whitewater = WhitewaterSettings;
  /// The sides of the domain. A side that is not set has `method`. If `method` is not set either,
  /// it is reflection for mueller2003 and akinci2012 for the other solvers.
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
    bool retry = true;                     // halve a step whose solve did not converge
    std::optional<Integrator> integrator;  // symplectic_euler for wcsph, else leapfrog
  };
  /// Samples the fluid at places while the simulation runs.
  struct Probe {
    std::string name;  // of its table, probes/NAME.csv; "probe_k" if empty
    ProbeKind kind = ProbeKind::point;
    Vector at;                    // point
    Vector from, to;              // line, surface; plane, wall: opposite corners
    std::int64_t count = 2;       // line: number of places, both ends included
    Vector along;                 // wall in 3D: direction of an edge; edges along axes if empty
    std::optional<double> apart;  // plane: distance of its places [m]; default: particles.spacing
    std::string body;             // name of the body that carries the probe; none if empty
    std::optional<double> every;  // [s]; default: with the observables
  };
  struct Output {
    std::optional<std::int64_t> frame_every_steps, observables_every_steps;
    std::optional<double> frame_every, observables_every;  // [s]
    bool statistics = false;  // of forces and probes, over all steps since the last row
    std::optional<std::int64_t> checkpoint_every_steps;
    std::optional<double> checkpoint_every;         // [s]
    std::vector<DataFormat> data{DataFormat::vtp};  // no data files if empty
    std::vector<DataField> fields{DataField::velocity, DataField::density, DataField::pressure,
                                  DataField::id};  // the position is always written
    Precision precision = Precision::float32;
    std::optional<std::int64_t> data_every_steps;  // if neither is set: with the frames
    std::optional<double> data_every;              // [s]
  };
  /// Meshes of the fluid in 3D.
  struct Surface : SurfaceMeshFiles {
    std::optional<std::int64_t> every_steps;  // if neither is set: with the data files
    std::optional<double> every;              // [s]
  };
  struct Picture {
    std::optional<std::int64_t> width, height;  // [px]; follow the domain
    bool stretch = false;                       // 2D: fills width and height
    std::optional<std::int64_t> dot_radius;     // [px]; 2D
    Dots dots = Dots::solid;                    // 2D
    PictureStyle style = PictureStyle::balls;   // 3D
    Vector window;                              // x_min, y_min, x_max, y_max; 2D
    ColorBy color_by = ColorBy::speed;
    std::optional<ColorMap> color_map;  // suits color_by
    Vector color_range;                 // minimum and maximum; by color_scale if empty
    ColorScale color_scale = ColorScale::run;
    std::string background = "night";  // a name, or "#rrggbb"
    bool time_stamp = false, scale_bar = false, color_bar = false;
  };
  /// The camera of pictures in 3D. Several cameras are key frames.
  struct Camera {
    double time = 0;            // of a key frame
    Vector position;            // if empty: in front, to the right and above
    Vector target;              // the middle of the domain if empty
    double field_of_view = 35;  // vertical [degrees]
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
  std::optional<Whitewater> whitewater;  // none if not set
  Walls walls;
  Time time;
  Output output;
  std::optional<Surface> surface;  // no meshes if empty
  Picture picture;
  std::vector<Camera> camera;
  Checks checks;

  /// The TOML text of this scene, overrides included; empty for a scene made in code.
  std::string source;
  /// The place of each key that is set: "fluid[0].count" -> "FILE:LINE:COLUMN" or "override KEY".
  std::map<std::string, std::string> places;

  int dimension() const { return int(domain.max.size()); }  ///< 2 or 3
  const SolverMethod& method() const { return method_of(solver.name); }
  /// Whether the teaching article's own step and constants are used: mueller2003 with
  /// solver.scheme = "article".
  bool is_article() const {
    return method().reads("solver.scheme") && solver.scheme == Scheme::article;
  }
  /// Fluids and inlets with equal rest density, viscosity and colour share one liquid.
  struct Liquid {
    double rest_density, viscosity;
    std::string color;
    bool operator==(const Liquid&) const = default;
  };
  /// The distinct liquids, in the order of their first fluid or inlet; fluids come first. A scene
  /// without both has the default liquid.
  std::vector<Liquid> liquids() const;
  /// The liquid of the k-th inlet: what it does not set is the first fluid's, or the default where
  /// there is no fluid.
  Liquid inlet_liquid(std::size_t k) const;
  /// The index of the k-th fluid's liquid in liquids().
  int liquid_of(std::size_t k) const;
  /// As set. Default: antuono2010 for several liquids, else fourtakas2019, which subtracts the
  /// hydrostatic density of a single liquid.
  DensityDiffusion density_diffusion() const;
  /// The number of fixed steps, round(end/step). For an adaptive run the estimate end/step_max.
  std::int64_t steps() const;
  /// The wall method of side 2d + (0: min, 1: max), d the axis. It ignores periodic axes.
  WallMethod side_method(int side) const;
  WallMethod wall_method(std::size_t k) const;
  /// Whether the fluid leaves through this side.
  bool is_open(int side) const {
    return !periodic(side / 2) && side_method(side) == WallMethod::open;
  }
  bool periodic(int axis) const { return int(domain.periodic) >> axis & 1; }
  Integrator integrator() const;
  /// As set. Default: artificial for wcsph and delta_sph, monaghan2005 for the others.
  ViscosityMethod viscosity_method() const;
  /// The names by which wall forces are reported: "x_min" ... "z_max", then the walls' names.
  std::vector<std::string> wall_names() const;
  /// Whether particles are added or removed during the run.
  bool has_flows() const;
  /// The names by which flows are reported: inlets, then outlets, then counters, then open sides.
  std::vector<std::string> flow_names() const;
  /// "inlet", "outlet", "counter" or "open side": what the k-th of flow_names() is.
  const char* flow_kind(std::size_t k) const;
  std::string body_name(std::size_t k) const;
};

/// A key and the value that replaces the scene's. The value is parsed as TOML; if that fails, it is
/// a string. Without a value, the key or table is removed; it must be in the scene. Diagnostics
/// have the place "override KEY" or "removal KEY".
using Override = std::pair<std::string, std::optional<std::string>>;

/// Loads and checks a scene.
/// Throws Error (kind scene) with every semantic error at once, or one syntax error alone.
Scene load_scene(const std::filesystem::path& file, const std::vector<Override>& overrides = {});

struct SceneChange {
  std::vector<Override> overrides;
  std::vector<Diagnostic> dropped;  ///< warnings: why each key is removed
};

/// The overrides that load a scene with another solver. They remove the keys of the file that this
/// solver does not use or whose value it does not support, so that its defaults apply. Keys that
/// `overrides` sets, and keys that the scene's own solver does not use either, stay and are errors
/// of load_scene.
SceneChange change_solver(const std::filesystem::path& file, const std::string& solver,
                          const std::vector<Override>& overrides = {});

/// Parses and checks a scene from TOML text. Messages use `name` as the file name.
/// Throws Error (kind scene) with every semantic error at once, or one syntax error alone.
Scene parse_scene(const std::string& text, const std::string& name,
                  const std::vector<Override>& overrides = {});

/// The overrides that change a scene to about `particles` particles. Particle lengths (spacing,
/// jitter, support radius) and the time step scale by one factor; fluid regions and domain stay.
/// With inlets, `particles` is the estimated maximum. Throws Error (kind scene) if a fluid is read
/// from a point file, whose spacing is fixed.
std::vector<Override> at_resolution(const Scene& scene, double particles);

/// The warnings for a valid scene: lattice errors above 2 %, a time step above its bound, ...
/// Throws Error (kind scene) if a function is NaN or infinite at a particle that it samples.
std::vector<Diagnostic> scene_warnings(const Scene& scene);

}  // namespace freshet
