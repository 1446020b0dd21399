// SPDX-License-Identifier: MIT
#pragma once
#include <string>
#include <utility>
#include <vector>

#include "freshet/scene.h"

namespace freshet {

/// A scene as a run folder stores it, complete with the files that it reads: its text, and the
/// contents of these files by their names in the text.
struct Inputs {
  std::string source;
  std::vector<std::pair<std::string, std::string>> files;
};
Inputs inputs_of(const Scene& scene);

}  // namespace freshet
