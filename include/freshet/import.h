// SPDX-License-Identifier: MIT
/// Scenes of other programs.
#pragma once
#include <filesystem>
#include <string>
#include <vector>

#include "freshet/error.h"

namespace freshet {

/// A key of the other program that a conversion does not take over as it is.
struct ImportNote {
  enum class Kind {
    instead,  ///< another value or method was taken
    missing,  ///< no counterpart: the key has no effect
    display,  ///< only for the other program's window, files or caches: no effect on the flow
  };
  Kind kind = Kind::missing;
  std::string place;    ///< "FILE:LINE:COLUMN"
  std::string key;      ///< "Materials[0].elasticityMethod"
  std::string message;  ///< what is taken instead, or why the key has no effect

  /// "PLACE: note: KEY: MESSAGE"
  std::string text() const;
};

/// A scene of another program, converted.
struct ImportedScene {
  std::string toml;  ///< the notes are its first comments
  std::vector<ImportNote> notes;
};

/// Converts a scene of SPlisHSPlasH. `file` is the name for messages; files that the scene names
/// are relative to its folder. The TOML names them relative to `folder`, the folder that it will be
/// in. Reads the files of meshes and points. Throws Error (kind scene) with every error at once, or
/// one syntax error alone.
ImportedScene import_splishsplash(const std::string& json, const std::filesystem::path& file,
                                  const std::filesystem::path& folder);
/// Reads the file and converts it.
ImportedScene import_splishsplash(const std::filesystem::path& file,
                                  const std::filesystem::path& folder);

/// Converts a case of DualSPHysics (Case_Def.xml), as import_splishsplash converts its scenes.
/// Needs pugixml when Freshet is built.
ImportedScene import_dualsphysics(const std::string& xml, const std::filesystem::path& file,
                                  const std::filesystem::path& folder);
/// Reads the file and converts it.
ImportedScene import_dualsphysics(const std::filesystem::path& file,
                                  const std::filesystem::path& folder);

}  // namespace freshet
