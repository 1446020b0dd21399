// SPDX-License-Identifier: MIT
/// Any bytes give the points of a scene, a frame, or an Error. The first byte is the format: a
/// letter of the table below in 3D, a capital in 2D. The file follows.
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
  require(e.kind() == freshet::Error::Kind::scene, "the error is not of kind scene");
  require(e.diagnostics().size() == 1, "there must be one diagnostic");
  require(e.diagnostics()[0].place.starts_with("fuzz."), "the diagnostic does not name the file");
  require(e.diagnostics()[0].message.size() < 300, "the message has 300 characters or more");
}

void read_cloud(std::string_view bytes, const char* file, int dimension) {
  try {
    const auto cloud = freshet::points_in(bytes, file, dimension);
    require(!cloud.x.empty() && cloud.x.size() % std::size_t(dimension) == 0, "incomplete points");
    require(cloud.v.empty() || cloud.v.size() == cloud.x.size(), "incomplete velocities");
  } catch (const freshet::Error& e) {
    check_error(e);
  }
}

/// Writes the frame that it read, and requires that reading it again gives the same frame.
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
              again.liquid == frame.liquid && again.step == frame.step && again.time == frame.time,
          "the frame changes when it is written and read again");
}

constexpr struct {
  char letter;
  const char* file;
} formats[] = {{'p', "fuzz.ply"}, {'c', "fuzz.csv"}, {'v', "fuzz.vtp"}, {'u', "fuzz.vtu"},
               {'k', "fuzz.vtk"}, {'x', "fuzz.xyz"}, {'b', "fuzz.bgeo"}};

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  if (size == 0) return 0;
  const std::string_view bytes(reinterpret_cast<const char*>(data) + 1, size - 1);
  for (const auto& format : formats) {
    if (std::tolower(data[0]) != format.letter) continue;
    read_cloud(bytes, format.file, std::isupper(data[0]) ? 2 : 3);
    read_frame(bytes, format.file);
  }
  return 0;
}
