// SPDX-License-Identifier: MIT
/// Common parts of the checks of a scene.
#pragma once
#include <fmt/format.h>

#include <optional>

#include "freshet/real.h"
#include "mesh/triangle_mesh.h"
#include "scene/check/check.h"
#include "scene/sample/point_cloud.h"

namespace freshet {

/// The place of a key. For a key that is not set, the place of its table, or the file.
std::string place_of(const Scene& scene, std::string key);

/// Collects errors, each at the place of the key that the remedy changes.
class Findings {
 public:
  explicit Findings(const Scene& scene) : scene_(scene) {}
  void error(const std::string& key, std::string message) {
    list.push_back({Diagnostic::Severity::error, place_of(scene_, key), std::move(message)});
  }
  /// Reports a key whose value the solver does not support.
  void unsupported(const std::string& key, std::string message) {
    error(key, std::move(message));
    if (given(key)) unused_keys.push_back({key, list.back()});
  }
  bool given(const std::string& key) const { return scene_.places.contains(key); }
  /// Reports a key that is set although nothing reads it.
  void unused(const std::string& key, const std::string& name, const std::string& remedy) {
    if (given(key)) unsupported(key, fmt::format("{} is not used; {}", name, remedy));
  }
  std::vector<Diagnostic> list;
  std::vector<UnusedKey> unused_keys;  // their errors are in the list as well

 private:
  const Scene& scene_;
};

inline constexpr const char* axis_names = "xyz";
/// A remedy for numbers of too few bits.
inline constexpr const char* or_in_double =
    sizeof(Real) == sizeof(float) ? ", or build with FRESHET_DOUBLE" : "";

/// A fluid, a wall, an outlet or a body, and its name in messages.
struct RegionAt {
  const Scene::Region& region;
  std::string path;  ///< "fluid[0]."
  std::string name;  ///< "fluid"
};

// One topic per function. `scene` has its defaults filled in.
void check_domain(const Scene& scene, Findings& out);
void check_sizes(const Scene& scene, Findings& out);  ///< every vector has one number per axis
void check_periodic(const Scene& scene, Findings& out);
/// Both return false if nothing can be counted or sampled at this spacing and support radius.
bool check_resolution(const Scene& scene, Findings& out);
bool check_particles(const Scene& scene, Findings& out);
void check_method(const Scene& scene, Findings& out);
void check_gravity(const Scene& scene, Findings& out);
void check_body_force(const Scene& scene, Findings& out);
void check_forces(const Scene& scene, Findings& out);  ///< the forces beside pressure
void check_scheme(const Scene& scene, Findings& out);
void check_time(const Scene& scene, Findings& out);
void check_output(const Scene& scene, Findings& out);
void check_surface_meshes(const Scene& scene, Findings& out);  ///< [surface]
/// False if the shape is invalid, so that other checks must skip it.
bool check_region(const Scene& scene, const RegionAt& at, Findings& out);
/// The points of a region's file; empty if it cannot be read.
std::optional<PointCloud> check_points(const Scene& scene, const RegionAt& at, Findings& out);
/// False if the mesh of a region's file is invalid, or unsuitable for the region.
bool check_mesh(const Scene& scene, const RegionAt& at, Findings& out);
/// The place and size of a hole, in words.
std::string hole_words(const MeshHole& hole);
/// The fluids whose places can be sampled, and the number of their places.
struct FluidCount {
  std::vector<std::size_t> good;
  double places = 0;
};
FluidCount check_fluids(const Scene& scene, Findings& out);
/// Requires a count of particles that check_count accepts, as it samples fluids, walls and bodies.
void check_room(const Scene& scene, const FluidCount& fluids, Findings& out);
/// False if the shape or method of a wall is invalid, so that it cannot be sampled.
bool check_walls(const Scene& scene, Findings& out);
void check_sides(const Scene& scene, Findings& out);
/// Inlets, outlets and counters. False if an inlet is invalid, so that fluids cannot be checked.
bool check_flows(const Scene& scene, bool walls_are_good, Findings& out);
/// The counters, and the names of all flows.
void check_counters(const Scene& scene, Findings& out);
/// False if a body is invalid, so that it cannot be sampled.
bool check_bodies(const Scene& scene, Findings& out);
/// False if the mass, the inertia or the locked axes of a free body are invalid.
bool check_free(const Scene& scene, const Scene::Body& body, const std::string& at, Findings& out);
/// False if a body is at a wrong place. Requires a count that check_count accepts.
bool check_body_places(const Scene& scene, bool walls_are_good, Findings& out);

/// Which parts of a scene can be counted.
struct Countable {
  bool walls, bodies, inlets;
};
/// Whether the particles of the scene are few enough to sample them. Estimates them without
/// sampling.
bool check_count(const Scene& scene, double fluid_places, const Countable& parts, Findings& out);

void check_body_names(const Scene& scene, Findings& out);
/// False if the box around a body, or the sphere around a round one, misses the domain.
bool check_body_reach(const Scene& scene, std::size_t body, Findings& out);
/// The body of that name. Null, and an error at the key, if it does not exist.
const Scene::Body* find_body(const Scene& scene, const std::string& name, const std::string& at,
                             const std::string& key, Findings& out);

void check_probes(const Scene& scene, Findings& out);
void check_picture(const Scene& scene, Findings& out);
void check_whitewater(const Scene& scene, Findings& out);
void check_camera(const Scene& scene, Findings& out);

/// Runs that are bound to fail, with `particles` at the start.
void check_stability(const Scene& scene, double particles, Findings& out);

bool good_domain(const Scene& scene);

}  // namespace freshet
