// SPDX-License-Identifier: MIT
#pragma once
#include <string>
#include <utility>
#include <vector>

#include "freshet/scene.h"

namespace freshet {

/// A scene as it lies in the folder of its run, which needs nothing outside: its text, and the
/// contents of the files that it reads, by the names that the text gives them.
struct Inputs {
  std::string source;
  std::vector<std::pair<std::string, std::string>> files;
};
Inputs inputs_of(const Scene& scene);

}  // namespace freshet
