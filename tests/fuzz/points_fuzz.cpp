// SPDX-License-Identifier: MIT
/// Any bytes are points of a scene, a frame, or an Error. The first byte is the format: p, c or v
/// for PLY, CSV or VTP in 3D, capitals in 2D; the file follows.
#include <cctype>
#include <cstdio>
#include <cstdlib>
#include <string_view>

#include "freshet/error.h"
#include "io/frame_data.h"
#include "io/frame_files.h"
#include "scene/sample/point_cloud.h"

namespace {

void require(bool good, const char* what) {
  if (good) return;
  std::fprintf(stderr, "%s\n", what);
  std::abort();
}

void check_error(const freshet::Error& e) {
  require(e.kind() == freshet::Error::Kind::scene, "not an error of a file");
  require(e.diagnostics().size() == 1, "not one error");
  require(e.diagnostics()[0].place.starts_with("fuzz."), "a message without a place");
  require(e.diagnostics()[0].message.size() < 300, "a message of more than a few lines");
}

void read_cloud(std::string_view bytes, const char* file, int dimension) {
  try {
    const auto cloud = freshet::points_in(bytes, file, dimension);
    require(!cloud.x.empty() && cloud.x.size() % std::size_t(dimension) == 0, "half a point");
    require(cloud.v.empty() || cloud.v.size() == cloud.x.size(), "half the velocities");
  } catch (const freshet::Error& e) {
    check_error(e);
  }
}

/// A frame that is read is written and read again alike.
void read_frame(std::string_view bytes, const char* file) {
  freshet::Frame frame;
  try {
    frame = freshet::frame_in(bytes, file);
  } catch (const freshet::Error& e) {
    return check_error(e);
  }
  const auto again = freshet::frame_in(freshet::encode_vtp(frame), "again.vtp");
  require(again.id == frame.id && again.x == frame.x && again.v == frame.v &&
              again.density == frame.density && again.pressure == frame.pressure &&
              again.step == frame.step && again.time == frame.time,
          "a frame that reads otherwise");
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  if (size == 0) return 0;
  const std::string_view bytes(reinterpret_cast<const char*>(data) + 1, size - 1);
  const char* file = nullptr;
  switch (std::tolower(data[0])) {
    case 'p':
      file = "fuzz.ply";
      break;
    case 'c':
      file = "fuzz.csv";
      break;
    case 'v':
      file = "fuzz.vtp";
      break;
    default:
      return 0;
  }
  read_cloud(bytes, file, std::isupper(data[0]) ? 2 : 3);
  read_frame(bytes, file);
  return 0;
}
