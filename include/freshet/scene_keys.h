// SPDX-License-Identifier: MIT
#pragma once
#include <string>
#include <vector>

#include "freshet/scene.h"

namespace freshet {

/// A key of a scene for a program that shows and edits it.
struct SceneKey {
  enum class Kind { number, integer, numbers, boolean, word, text, texts, other };
  std::string path;     ///< as an Override names it: "fluid[0].viscosity"
  std::string section;  ///< "fluid[0]"
  std::string name;     ///< "viscosity"
  std::string unit, text;
  Kind kind = Kind::other;
  std::string value;               ///< TOML; that of the scene, else a fixed default; may be empty
  bool is_set = false;             ///< the scene sets it
  std::string fallback;            ///< the default in words, if it is not a fixed value
  double min, max;                 ///< range of numbers, infinity without a limit
  bool above = false;              ///< min itself is not allowed
  std::vector<std::string> words;  ///< the values of a word
  bool live = false;               ///< may_change_while_running()
};

/// The keys of the sections that a scene has, and of the sections that occur once, in the order of
/// docs/scene.md. Keys that the scene's solver does not use are skipped. Empty for a scene made in
/// code.
std::vector<SceneKey> keys_of(const Scene& scene);

/// Whether Simulation::change accepts a key: gravity, viscosities, surface tension, stiffness and
/// the like, which change neither the particles nor the fields of the state.
bool may_change_while_running(const std::string& path);

}  // namespace freshet
