// SPDX-License-Identifier: MIT
#include "scene/sample/point_cloud.h"

#include <fmt/format.h>

#include "core/input_file.h"
#include "core/table_text.h"
#include "formats/column_names.h"
#include "formats/point_formats.h"
#include "freshet/error.h"
#include "scene/model/region_rotation.h"

namespace freshet {
namespace {

/// Collects positions and velocities, and rejects invalid ones.
class PointColumns final : public PointSink {
 public:
  PointColumns(std::string file, int dimension)
      : PointSink(std::move(file)), dimension_(dimension) {}

  PointCloud cloud;

  void name(const std::string& column, std::size_t place) override;
  void skip(const std::string& array) override { cloud.unused.push_back(array); }
  void check() override;
  bool reads(std::size_t place) const override {
    return std::find(place_, place_ + 6, std::ptrdiff_t(place)) != place_ + 6;
  }
  void add(const std::vector<double>& values) override;

 private:
  void drop_uncertain();
  bool has_velocity() const { return place_[3] >= 0 || place_[4] >= 0 || place_[5] >= 0; }

  int dimension_;
  std::ptrdiff_t place_[6] = {-1, -1, -1, -1, -1, -1};
  bool certain_[6] = {};
  std::vector<std::pair<std::string, std::size_t>> columns_;
};

void PointColumns::name(const std::string& column, std::size_t place) {
  columns_.emplace_back(column, place);
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
  for (int k = 3; k < 6; ++k)
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
    if (dimension_ == 2 && place_[k] >= 0 && value(k) != 0)
      fail(fmt::format("{} is {:g}, and the scene is in 2D; make it 0, or add z to domain.max",
                       k == 2 ? "z" : "vz", value(k)));
}

}  // namespace

PointCloud points_in(std::string_view bytes, const std::filesystem::path& file, int dimension) {
  PointColumns columns(file.string(), dimension);
  const PointFormat* format = point_format_of(file);
  if (!format)
    columns.fail(fmt::format("not a known format of points ({}); {}", point_extensions(),
                             other_format_remedy(file)));
  format->read(bytes, columns);
  columns.line = 0;
  if (columns.cloud.x.empty()) columns.fail("the file has no points; name another file");
  return std::move(columns.cloud);
}

PointCloud read_points(const std::filesystem::path& file, int dimension) {
  const std::string remedy = "name a " + point_extensions() + " file";
  const InputFile point_file{.noun = "point file", .remedy = remedy.c_str()};
  return points_in(read_input(file, point_file), file, dimension);
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

}  // namespace

PointCloud region_points(const Scene::Region& region, int dimension) {
  PointCloud cloud = read_points(region.file, dimension);
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

}  // namespace freshet
