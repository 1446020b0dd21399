// SPDX-License-Identifier: MIT
#include "io/frame_columns.h"

#include <fmt/format.h>

#include <algorithm>

namespace freshet {
namespace {

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
    if (place_[0] < 0 || place_[1] < 0)
      fail("the columns x and y are missing; name a data file of a run");
    if (given_dimension_ == 3 && place_[2] < 0)
      fail("the column z is missing; the file is damaged");
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
  DataFields stored() const {
    DataFields fields;
    const std::ptrdiff_t* v = place_ + 3;
    fields.velocity = std::all_of(v, v + dimension(), [](std::ptrdiff_t at) { return at >= 0; });
    fields.density = place_[6] >= 0;
    fields.pressure = place_[7] >= 0;
    fields.id = place_[8] >= 0;
    return fields;
  }

 private:
  static constexpr const char* names[] = {"x",    "y",       "z",        "vx", "vy",
                                          "vz",   "density", "pressure", "id", "step",
                                          "time", "liquid",  "kind",     "age"};
  int dimension() const { return given_dimension_ ? given_dimension_ : place_[2] < 0 ? 2 : 3; }
  double finite(double value) const {
    if (!(std::abs(value) <= 3e38))  // true for NaN as well
      fail(fmt::format("a number is {}; the file is damaged", value));
    return value;
  }
  double whole(double value) const {
    if (!(value >= 0 && value <= 9007199254740992.0 && value == std::floor(value)))
      fail(fmt::format(
          "an id, step or liquid is {} and must be a whole number; the file is damaged", value));
    return value;
  }

  Frame frame_;
  int given_dimension_ = 0;
  std::ptrdiff_t place_[std::size(names)] = {-1, -1, -1, -1, -1, -1, -1,
                                             -1, -1, -1, -1, -1, -1, -1};
};

void FrameColumns::add(const std::vector<double>& values) {
  const auto has = [&](int k) { return place_[k] >= 0; };
  const auto value = [&](int k) { return has(k) ? finite(values[std::size_t(place_[k])]) : 0.0; };
  if (has(9)) frame_.step = std::int64_t(whole(value(9)));
  if (has(10)) frame_.time = value(10);
  const auto add_to = [&](auto& points) {
    for (int k = 0; k < dimension(); ++k) {
      points.x.push_back(float(value(k)));
      points.v.push_back(float(value(3 + k)));
    }
    points.id.push_back(has(8) ? std::uint64_t(whole(value(8))) : points.size());
  };
  if (has(12)) {  // whitewater
    add_to(frame_.whitewater);
    frame_.whitewater.kind.push_back(int(std::min(whole(value(12)), 3.0)));
    frame_.whitewater.age.push_back(float(value(13)));
    if (frame_.whitewater.kind.back() > 2) fail("a kind is not 0, 1 or 2; the file is damaged");
    return;
  }
  add_to(frame_);
  frame_.density.push_back(float(value(6)));
  frame_.pressure.push_back(float(value(7)));
  if (has(11)) frame_.liquid.push_back(int(std::min(whole(value(11)), 1e9)));
}

}  // namespace

Frame decode_columns(std::string_view bytes, const std::string& file, PointReader* read,
                     DataFields& stored) {
  FrameColumns columns(file);
  read(bytes, columns);
  stored = columns.stored();
  return columns.take();
}

Frame decode_csv(std::string_view bytes, const std::string& file, DataFields& stored) {
  if (!bytes.empty() && !bytes.ends_with('\n'))
    FilePlace(file).fail("the last line has no end; the file is cut off");
  return decode_columns(bytes, file, read_csv, stored);
}

}  // namespace freshet
