// SPDX-License-Identifier: MIT
/// Any contents of a checkpoint with the right digest give an Error that changes nothing, or a
/// state that can be read. The input is the text of run.json, a zero byte, and bytes that are added
/// to those of the arrays. The target writes the HDF5 file itself: damage of that format is the
/// library's matter.
#include <algorithm>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <span>
#include <string>
#include <string_view>

#include "freshet/simulation.h"
#include "io/checkpoint.h"
#include "io/hdf5.h"

namespace {

constexpr const char* scene = R"([domain]
max = [1, 1]
[particles]
spacing = 0.1
[[fluid]]
min = [0, 0]
max = [1, 0.2]
[[fluid]]
rest_density = 900
min = [0, 0.2]
max = [1, 0.3]
[[inlet]]
center = [0.5, 0.8]
direction = [1, 0]
width = 0.2
speed = 1
[[outlet]]
min = [0.8, 0]
max = [1, 1]
[solver]
name = "wcsph"
sound_speed = 30
[time]
end = 1
step = 0.001
)";

void require(bool good, const char* what) {
  if (good) return;
  std::fprintf(stderr, "%s\n", what);
  std::abort();
}

/// The first part of `bytes` goes to this array.
void write_array(freshet::Hdf5Writer& file, const freshet::Checkpoint::Array& a,
                 std::string_view& bytes) {
  std::vector<std::byte> values = a.bytes;
  for (std::size_t k = 0; k < values.size() && !bytes.empty(); ++k, bytes.remove_prefix(1))
    values[k] ^= std::byte(bytes.front());
  const auto write = [&](auto number) {
    std::vector<decltype(number)> numbers(values.size() / sizeof number);
    std::memcpy(numbers.data(), values.data(), values.size());
    file.write(a.name, std::span<const decltype(number)>(numbers), std::size_t(a.components));
  };
  using Number = freshet::StateArray::Number;
  if (a.number == Number::int32) write(std::int32_t());
  if (a.number == Number::uint64) write(std::uint64_t());
  if (a.number == Number::float32) write(float());
  if (a.number == Number::float64) write(double());
}

freshet::Simulation started() {
  freshet::Simulation sim(freshet::parse_scene(scene, "fuzz"), {1, ""});
  for (int k = 0; k < 3; ++k) sim.step();
  return sim;
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  static freshet::Simulation sim = started();
  static const freshet::Checkpoint valid = sim.checkpoint();
  std::string_view input(reinterpret_cast<const char*>(data), size);
  const std::size_t end = std::min(input.find('\0'), input.size());
  std::string_view rest = input.substr(std::min(end + 1, input.size()));
  freshet::Hdf5Writer file;
  file.write_text("scene.toml", scene);
  file.write_text("run.json", std::string(input.substr(0, end)));
  for (const auto& array : valid.arrays) write_array(file, array, rest);
  const std::string before = sim.kept_sha256();
  try {
    const auto c = freshet::decode_checkpoint(freshet::sealed_checkpoint(file.bytes()), "fuzz.h5");
    sim.restore(c);
    require(sim.frame().size() == sim.fluid().size(), "the frame is incomplete");
    sim.statistics();
    sim.flows();
  } catch (const freshet::Error& e) {
    require(e.diagnostics().size() == 1, "there must be one diagnostic");
    require(sim.kept_sha256() == before, "the state changes though the checkpoint is rejected");
  }
  sim.restore(valid);
  return 0;
}
