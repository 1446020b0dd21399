// SPDX-License-Identifier: MIT
/// The parts of a scene of SPlisHSPlasH. Each part reads its block of the JSON and returns tables
/// of TOML.
#pragma once
#include <cmath>
#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "import/json_object.h"
#include "import/placement.h"
#include "import/toml_text.h"

namespace freshet {

/// What all parts need to know.
struct SplishWorld {
  std::filesystem::path from;  ///< folder of the JSON file
  std::filesystem::path to;    ///< folder of the TOML
  int dimension = 3;
  double radius = 0.025;  ///< of a particle [m]
  /// All fluid is points of files, which are sampled for the mass 0.8 rho0 (2r)^3.
  bool only_points = false;
  bool particle_walls = false;  ///< boundaryHandlingMethod 0: a wall has no inside
  double duration = 5;          ///< [s]
  bool has_fluid = false;       ///< besides what emitters bring
  double fastest = 0;           ///< speed that a fluid starts with or an emitter gives [m/s]
  std::optional<Bounds> tank;   ///< the box that holds the fluid
  Bounds extent;                ///< of everything but the tank

  double spacing() const {
    return 2 * radius * (only_points ? std::pow(0.8, 1.0 / dimension) : 1.0);
  }
  bool flat() const { return dimension == 2; }
  /// A file of the scene as the TOML names it.
  std::string file_in_toml(const std::string& file) const;
};

/// "Configuration". The result: [particles], [solver], [time], [output], [camera].
struct SplishSettings {
  Vec<3, double> gravity{0, -9.81, 0};
  int method = 4;
  double bulk_modulus = 0;          ///< of WCSPH [Pa]
  std::optional<JsonObject> wcsph;  ///< its block
  TomlTable particles, solver, time, output, camera;
};
SplishSettings read_splish_settings(JsonObject config, SplishWorld& world);

/// A material, as the tables [[fluid]] and [[inlet]] have it.
struct SplishLiquid {
  double rest_density = 1000, viscosity = 0;  ///< [kg/m³], [Pa s]
  std::string color;                          ///< if the scene has several
  std::optional<double> surface_tension;      ///< [N/m]
  // of emitters
  long max_particles = 10000;
  bool reuse = false;
  Bounds reuse_box;

  TomlTable of_fluid() const;
  TomlTable of_inlet() const;
};

/// "Materials".
struct SplishMaterials {
  std::map<std::string, SplishLiquid> liquids;  ///< by id
  bool sticks = false;                          ///< no_slip walls
  double xsph = 0;
  TomlTable solver, air, picture;

  const SplishLiquid& liquid(const std::string& id) const;
};
/// `ids`: those that blocks, models and emitters name, in their order.
SplishMaterials read_splish_materials(std::vector<JsonObject> materials,
                                      const std::vector<std::string>& ids,
                                      const SplishWorld& world);

/// Whether a "particleFile" is a mesh to fill, not points.
bool is_mesh_file(const std::string& file);

/// "FluidBlocks" and "FluidModels": the tables [[fluid]].
std::string read_splish_fluids(std::vector<JsonObject> blocks, std::vector<JsonObject> models,
                               const SplishMaterials& materials, SplishWorld& world);

/// "RigidBodies" and joints: the tables [[wall]], [[body]] and [[joint]].
std::string read_splish_bodies(JsonObject& scene, bool sticks, SplishWorld& world);

/// "Emitters": the tables [[inlet]] and [[outlet]].
std::string read_splish_emitters(std::vector<JsonObject> emitters, const SplishMaterials& materials,
                                 SplishWorld& world);

/// The rotation and translation of a model, a body or an emitter.
Placement read_splish_placement(JsonObject& object);

}  // namespace freshet
