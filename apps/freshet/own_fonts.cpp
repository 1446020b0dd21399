// SPDX-License-Identifier: MIT
#include "own_fonts.h"

#include <cstdlib>

#include "command.h"

namespace freshet::cli {

void find_own_fonts() {
  std::error_code ec;
  for (const auto& folder : folders_that_come_along("fonts"))
    if (std::filesystem::is_regular_file(folder / "fonts.conf", ec)) {
      setenv("FONTCONFIG_FILE", (folder / "fonts.conf").c_str(), 0);
      return;
    }
}

}  // namespace freshet::cli
