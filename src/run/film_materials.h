// SPDX-License-Identifier: MIT
/// How liquids and bodies look in a film.
#pragma once
#include <string>
#include <vector>

#include "freshet/scene.h"
#include "render/image.h"

namespace freshet {

struct LiquidMaterial {
  std::string color;      ///< stays deep in the liquid: "#rrggbb"
  double ior;             ///< refractive index
  double absorption;      ///< optical depth over the longest side of what the film shows
  double scattering = 0;  ///< share of the light that is scattered at the surface: 1 is opaque
  double roughness = 0;   ///< 0: clear and mirroring, 1: matte
};

struct BodyMaterial {
  std::string kind = "matte";  ///< or "plastic", "metal", "glass", "wood"
  std::string color;           ///< "#rrggbb"
  double roughness = 1;
  double ior = 1.5;  ///< of glass
};

struct FilmMaterials {
  std::vector<LiquidMaterial> liquids;  ///< in the order of Scene::liquids()
  std::vector<BodyMaterial> bodies;     ///< in the order of Scene::body
};

/// The materials of a scene, changed by choices such as "liquid=milk", "liquid1=oil",
/// "rabbit=metal,color=#c0a040". Throws Error (kind scene) at "option material CHOICE".
FilmMaterials film_materials(const Scene& scene, const std::vector<std::string>& choices);

/// "#rrggbb".
std::string hex_code(Color color);

}  // namespace freshet
