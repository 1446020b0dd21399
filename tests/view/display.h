// SPDX-License-Identifier: MIT
/// A display for tests of the window, and a scene that is easy to find in pictures.
#pragma once
#include <chrono>
#include <cstring>
#include <string>
#include <thread>

#include "cli/files.h"
#include "cli/process.h"
#include "render/image.h"

namespace freshet::test {

inline constexpr const char* red_block = R"(
[domain]
max = [DOMAIN]
[particles]
spacing = 0.05
[fluid]
shape = "box"
min = [ORIGIN]
max = [FLUID]
color = "#ff2010"
[solver]
name = "wcsph"
[time]
end = 1.0
step = 0.0005
[picture]
color_by = "liquid"
)";

/// A red block of liquid in a tank.
inline std::string red_scene(int dimension) {
  std::string text = red_block;
  const auto put = [&](const char* what, const char* value) {
    text.replace(text.find(what), std::strlen(what), value);
  };
  put("DOMAIN", dimension == 2 ? "2.0, 1.0" : "1.6, 1.0, 0.8");
  put("ORIGIN", dimension == 2 ? "0.0, 0.0" : "0.0, 0.0, 0.0");
  put("FLUID", dimension == 2 ? "0.8, 0.6" : "0.6, 0.6, 0.5");
  return text;
}

inline bool is_red(Color c) { return c.r > 70 && c.r > 2 * c.b; }

inline bool has_program(const char* name) {
  return run_process({"sh", "-c", std::string("command -v ") + name}).code == 0;
}

/// A display without a screen, which the destructor ends.
class Display {
 public:
  explicit Display(const std::string& options = "")
      : server_(
            {"sh", "-c", "exec Xvfb -displayfd 3 -screen 0 1600x1200x24 " + options + " 3>number"},
            {.directory = folder_.path()}) {
    for (int k = 0; k < 500 && !name.ends_with("\n"); ++k) {
      std::this_thread::sleep_for(std::chrono::milliseconds(20));
      name = ":" + read_text(folder_ / "number");
    }
    name.pop_back();
  }
  std::string name;

 private:
  TemporaryFolder folder_;
  Process server_;
};

}  // namespace freshet::test
