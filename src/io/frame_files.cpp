// SPDX-License-Identifier: MIT
#include "io/frame_files.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <optional>

#include "core/input_file.h"
#include "formats/point_sink.h"
#include "freshet/error.h"
#include "io/frame_hdf5.h"

namespace freshet {
namespace {

namespace fs = std::filesystem;

/// Collects the columns of a parser in a frame.
class FrameColumns final : public PointSink {
 public:
  explicit FrameColumns(std::string file) : PointSink(std::move(file)) {}

  void name(const std::string& column, std::size_t place) override {
    const auto known = std::find(std::begin(names), std::end(names), column);
    if (known == std::end(names)) return;
    auto& at = place_[known - std::begin(names)];
    if (at >= 0) fail(fmt::format("{} is named twice; name every column once", column));
    at = std::ptrdiff_t(place);
  }
  void check() override {
    if (place_[0] < 0 || place_[1] < 0) fail("there is no x or no y; is it the right file?");
    if (given_dimension_ == 3 && place_[2] < 0) fail("there is no z; the file is damaged");
  }
  bool reads(std::size_t place) const override {
    return std::find(std::begin(place_), std::end(place_), std::ptrdiff_t(place)) !=
           std::end(place_);
  }
  void note(std::string_view word, double value) override {
    if (word == "time") frame_.time = finite(value);
    if (word == "step") frame_.step = std::int64_t(whole(value));
    if (word == "dimension") {
      if (value != 2 && value != 3) fail("its dimension is neither 2 nor 3; the file is damaged");
      given_dimension_ = int(value);
    }
  }
  void add(const std::vector<double>& values) override;
  Frame take() {
    frame_.dimension = dimension();
    return std::move(frame_);
  }

 private:
  static constexpr const char* names[] = {"x",       "y",        "z",  "vx",   "vy",   "vz",
                                          "density", "pressure", "id", "step", "time", "liquid"};
  int dimension() const { return given_dimension_ ? given_dimension_ : place_[2] < 0 ? 2 : 3; }
  double finite(double value) const {
    if (!(std::abs(value) <= 3e38))  // true for NaN as well
      fail(fmt::format("a number is {}; the file is damaged", value));
    return value;
  }
  double whole(double value) const {
    if (!(value >= 0 && value <= 9007199254740992.0 && value == std::floor(value)))
      fail(fmt::format(
          "an id, a step or a liquid is {}, and they are whole numbers; the file is damaged",
          value));
    return value;
  }

  Frame frame_;
  int given_dimension_ = 0;
  std::ptrdiff_t place_[std::size(names)] = {-1, -1, -1, -1, -1, -1, -1, -1, -1, -1, -1, -1};
};

void FrameColumns::add(const std::vector<double>& values) {
  const auto has = [&](int k) { return place_[k] >= 0; };
  const auto value = [&](int k) { return has(k) ? finite(values[std::size_t(place_[k])]) : 0.0; };
  const std::size_t i = frame_.size();
  for (int k = 0; k < dimension(); ++k) {
    frame_.x.push_back(float(value(k)));
    frame_.v.push_back(float(value(3 + k)));
  }
  frame_.density.push_back(float(value(6)));
  frame_.pressure.push_back(float(value(7)));
  frame_.id.push_back(has(8) ? std::uint64_t(whole(value(8))) : i);
  if (has(9)) frame_.step = std::int64_t(whole(value(9)));
  if (has(10)) frame_.time = value(10);
  if (has(11)) frame_.liquid.push_back(int(std::min(whole(value(11)), 1e9)));
}

constexpr const char* extensions[] = {".h5", ".vtp", ".ply", ".csv"};

/// The number of "frame_0007.vtp"; empty for names that data_file would not give.
std::optional<std::int64_t> number_of_frame(const fs::path& file, const std::string& extension) {
  const std::string name = file.filename().string();
  std::int64_t number = 0;
  if (!name.starts_with("frame_")) return {};
  std::from_chars(name.data() + 6, name.data() + name.size(), number);
  if (number < 0 || name != fmt::format("frame_{:04}{}", number, extension)) return {};
  return number;
}

}  // namespace

std::vector<FrameFile> frame_files(const fs::path& run_folder) {
  for (const char* extension : extensions) {
    std::vector<FrameFile> files;
    std::error_code ec;  // a missing folder has no files
    for (const auto& entry : fs::directory_iterator(run_folder / "data", ec))
      if (const auto number = number_of_frame(entry.path(), extension))
        files.push_back({entry.path(), *number});
    std::sort(files.begin(), files.end(),
              [](const FrameFile& a, const FrameFile& b) { return a.number < b.number; });
    if (!files.empty()) return files;
  }
  return {};
}

Frame frame_in(std::string_view bytes, const fs::path& file) {
  const std::string extension = file.extension().string();
  if (extension == ".h5") return decode_hdf5(bytes, file.string());
  FrameColumns columns(file.string());
  if (extension == ".vtp") read_vtp(bytes, columns);
  else if (extension == ".ply") read_ply(bytes, columns);
  else if (extension == ".csv") {
    if (!bytes.empty() && !bytes.ends_with('\n'))
      columns.fail("the last line has no end; the file is cut off");
    read_csv(bytes, columns);
  } else columns.fail("not *.h5, *.vtp, *.ply or *.csv; name a data file of a run");
  return columns.take();
}

Frame read_frame(const fs::path& file) {
  constexpr InputFile data_file{.noun = "data file", .remedy = "name a data file of a run"};
  return frame_in(read_input(file, data_file), file);
}

}  // namespace freshet
