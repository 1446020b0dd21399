// SPDX-License-Identifier: MIT
#include "formats/file_place.h"

#include <fmt/format.h>

#include "freshet/error.h"

namespace freshet {

void FilePlace::fail(const std::string& why) const {
  throw Error(Error::Kind::scene, line ? fmt::format("{}:{}", file_, line) : file_, why);
}

}  // namespace freshet
