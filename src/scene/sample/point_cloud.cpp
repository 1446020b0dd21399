// SPDX-License-Identifier: MIT
#include "scene/sample/point_cloud.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "core/input_file.h"
#include "core/table_text.h"
#include "formats/column_names.h"
#include "formats/point_formats.h"
#include "freshet/error.h"
#include "scene/model/region_rotation.h"

namespace freshet {
namespace {

// Indices of what a column can hold, after the position
constexpr int velocity_place = 3, density_place = 6, pressure_place = 7, liquid_place = 8,
              time_place = 9, place_count = 10;
constexpr const char* state_names[] = {"density", "pressure", "liquid", "time"};

/// Collects positions and velocities, and rejects invalid ones. With `state`, it also collects what
/// else a run writes.
class PointColumns final : public PointSink {
 public:
  PointColumns(std::string file, int dimension, bool state)
      : PointSink(std::move(file)),
        dimension_(dimension > 0 ? dimension : 2),
        any_dimension_(dimension == 0),
        state_(state) {}

  PointCloud cloud;

  void name(const std::string& column, std::size_t place) override;
  void skip(const std::string& array) override { cloud.unused.push_back(array); }
  void check() override;
  bool reads(std::size_t place) const override {
    return std::find(place_, place_ + place_count, std::ptrdiff_t(place)) != place_ + place_count;
  }
  void note(std::string_view name, double value) override;
  void add(const std::vector<double>& values) override;

 private:
  void drop_uncertain();
  void add_state(const std::vector<double>& values);
  bool has_velocity() const { return place_[3] >= 0 || place_[4] >= 0 || place_[5] >= 0; }

  int dimension_;
  bool any_dimension_, state_;
  std::ptrdiff_t place_[place_count] = {-1, -1, -1, -1, -1, -1, -1, -1, -1, -1};
  bool certain_[place_count] = {};
  std::vector<std::pair<std::string, std::size_t>> columns_;
};

void PointColumns::name(const std::string& column, std::size_t place) {
  columns_.emplace_back(column, place);
  for (int k = 0; state_ && k < place_count - density_place; ++k)
    if (plain_name(column) == state_names[k]) place_[density_place + k] = std::ptrdiff_t(place);
  const auto known = point_column(column);
  if (!known) return;
  const auto k = std::size_t(known->component);
  if (place_[k] >= 0 && certain_[k] == known->certain)
    fail(fmt::format("{} is named twice; name every column once", shown(column)));
  if (place_[k] >= 0 && certain_[k]) return;
  place_[k] = std::ptrdiff_t(place);
  certain_[k] = known->certain;
}

/// u, v and w are velocities if all of them are there and nothing else is.
void PointColumns::drop_uncertain() {
  bool together = true;
  for (int k = 0; k < dimension_; ++k) together &= place_[3 + k] >= 0 && !certain_[3 + k];
  for (int k = velocity_place; k < density_place; ++k)
    if (!together && !certain_[k]) place_[k] = -1;
}

void PointColumns::check() {
  drop_uncertain();
  std::vector<std::string> names;
  for (const auto& [column, place] : columns_) {
    names.push_back(column);
    if (!reads(place)) cloud.unused.push_back(column);
  }
  static constexpr const char* axes[] = {"x", "y", "z"};
  for (int k = 0; k < dimension_; ++k)
    if (place_[k] < 0)
      fail(fmt::format(
          "{} is missing; a {}D scene needs x, y{} and optionally {}; columns found: {}", axes[k],
          dimension_, dimension_ == 3 ? ", z" : "", dimension_ == 3 ? "vx, vy, vz" : "vx, vy",
          listed_names(names)));
  for (int k = 0; k < dimension_; ++k)
    if (has_velocity() && place_[3 + k] < 0)
      fail(
          fmt::format("v{} is missing, and another velocity is present; write all {} or none; "
                      "columns found: {}",
                      axes[k], dimension_, listed_names(names)));
}

void PointColumns::note(std::string_view name, double value) {
  if (!state_) return;
  if (name == "time") cloud.time = value;
  if (name == "dimension" && !any_dimension_ && value != dimension_)
    fail(fmt::format("this frame is in {:g}D, and the scene is in {}D; choose a run in {}D", value,
                     dimension_, dimension_));
}

void PointColumns::add_state(const std::vector<double>& values) {
  const auto value = [&](int k) { return values[std::size_t(place_[k])]; };
  if (place_[density_place] >= 0) cloud.density.push_back(value(density_place));
  if (place_[pressure_place] >= 0) cloud.pressure.push_back(value(pressure_place));
  if (place_[liquid_place] >= 0)
    cloud.liquid.push_back(int(std::clamp(value(liquid_place), -1.0, 1e9)));
  if (place_[time_place] >= 0) cloud.time = value(time_place);
  if (!cloud.density.empty() && !(cloud.density.back() > 0 && cloud.density.back() < 1e15))
    fail(fmt::format("a density is {}; it must be greater than 0", cloud.density.back()));
  if (!cloud.pressure.empty() && !std::isfinite(cloud.pressure.back()))
    fail(fmt::format("a pressure is {}; it must be finite", cloud.pressure.back()));
}

void PointColumns::add(const std::vector<double>& values) {
  const auto value = [&](int k) {
    const double v = values[std::size_t(place_[k])];
    if (!(std::abs(v) <= 1e15))  // rejects NaN, too
      fail(fmt::format("a number is {}; positions and velocities must be finite, at most 1e15", v));
    return v;
  };
  for (int k = 0; k < dimension_; ++k) cloud.x.push_back(value(k));
  for (int k = 0; k < dimension_ && has_velocity(); ++k) cloud.v.push_back(value(3 + k));
  for (const int k : {2, 5})
    if (dimension_ == 2 && !any_dimension_ && place_[k] >= 0 && value(k) != 0)
      fail(fmt::format("{} is {:g}, and the scene is in 2D; make it 0, or add z to domain.max",
                       k == 2 ? "z" : "vz", value(k)));
  if (line > 0) cloud.lines.push_back(line);
  if (state_) add_state(values);
}

PointCloud cloud_in(std::string_view bytes, const std::filesystem::path& file, int dimension,
                    bool state) {
  PointColumns sink(file.string(), dimension, state);
  const PointFormat* format = point_format_of(file);
  if (!format)
    sink.fail(fmt::format("not a known format of points ({}); {}", point_extensions(),
                          other_format_remedy(file)));
  format->read(bytes, sink);
  sink.line = 0;
  if (sink.cloud.x.empty()) sink.fail("the file has no points; name another file");
  return std::move(sink.cloud);
}

std::string bytes_of(const std::filesystem::path& file) {
  const std::string remedy = "name a " + point_extensions() + " file";
  const InputFile point_file{.noun = "point file", .remedy = remedy.c_str()};
  return read_input(file, point_file);
}

/// Keeps the numbers of those points that are chosen, `n` each.
void keep_chosen(std::vector<double>& numbers, const std::vector<bool>& chosen, std::size_t n) {
  std::size_t kept = 0;
  for (std::size_t i = 0; i < numbers.size(); ++i)
    if (chosen[i / n]) numbers[kept++] = numbers[i];
  numbers.resize(kept);
}

}  // namespace

PointCloud points_in(std::string_view bytes, const std::filesystem::path& file, int dimension) {
  return cloud_in(bytes, file, dimension, false);
}

PointCloud read_points(const std::filesystem::path& file, int dimension) {
  return cloud_in(bytes_of(file), file, dimension, false);
}

PointCloud read_state(const std::filesystem::path& file, int dimension) {
  return cloud_in(bytes_of(file), file, dimension, true);
}

namespace {

/// Applies `change` to each vector of `all`, D numbers each.
template <class Change>
void for_each_vector(std::vector<double>& all, std::size_t D, const Change& change) {
  for (std::size_t i = 0; i + D <= all.size(); i += D) {
    Vec<3, double> a{all[i], all[i + 1], D == 3 ? all[i + 2] : 0};
    a = change(a);
    for (std::size_t k = 0; k < D; ++k) all[i + k] = component(a, int(k));
  }
}

/// Scales, rotates and translates points as their region says. Velocities are rotated.
PointCloud placed(PointCloud cloud, const Scene::Region& region, int dimension) {
  const bool turned = !region.rotation.empty();
  if (region.scale == 1 && !turned && region.translation.empty()) return cloud;
  const auto D = std::size_t(dimension);
  const RegionRotation turn(region.rotation);
  Vec<3, double> shift{};
  for (std::size_t k = 0; k < region.translation.size(); ++k)
    component(shift, int(k)) = region.translation[k];
  for_each_vector(cloud.x, D, [&](const Vec<3, double>& a) {
    return (turned ? turn(region.scale * a) : region.scale * a) + shift;
  });
  if (turned) for_each_vector(cloud.v, D, [&](const Vec<3, double>& a) { return turn(a); });
  return cloud;
}

}  // namespace

PointCloud region_points(const Scene::Region& region, int dimension) {
  return placed(read_points(region.file, dimension), region, dimension);
}

PointCloud points_of(const Scene::Fluid& f, int dimension) {
  if (f.from_run.empty()) return region_points(f, dimension);
  PointCloud cloud = placed(read_state(f.file, dimension), f, dimension);
  if (!f.liquid || cloud.liquid.empty()) return cloud;
  std::vector<bool> chosen;
  for (const int liquid_of_point : cloud.liquid) chosen.push_back(liquid_of_point == *f.liquid);
  const auto n = std::size_t(dimension);
  keep_chosen(cloud.x, chosen, n);
  keep_chosen(cloud.v, chosen, n);
  keep_chosen(cloud.density, chosen, 1);
  keep_chosen(cloud.pressure, chosen, 1);
  cloud.liquid.assign(cloud.x.size() / n, int(*f.liquid));
  return cloud;
}

}  // namespace freshet
