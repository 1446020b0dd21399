// SPDX-License-Identifier: MIT
#include "window/window.h"

namespace freshet::window {

Result show(const Options&) {
  throw Error(Error::Kind::run, "",
              "this build of Freshet has no window; install libglfw3-dev, libimgui-dev and "
              "libgl-dev (names of Debian), then build it again");
}

}  // namespace freshet::window
