// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <algorithm>
#include <optional>

#include "io/frame_data.h"
#include "render/draw.h"
#include "render/png.h"
#include "run/body_table.h"
#include "run/interval.h"
#include "run/observables.h"
#include "run/output.h"
#include "run/percentile_table.h"
#include "run/surface_output.h"
#include "run/video_output.h"
#include "scene/model/body_mesh.h"
#include "scene/model/body_shape.h"
#include "sim/probes.h"

namespace freshet {
namespace {

/// observables.csv: a row of sums and extremes.
class Observables final : public Output {
 public:
  explicit Observables(const RunSite& site) : site_(site), before_(site.sim.moment()) {}
  const char* name() const override { return "observables"; }
  std::vector<std::string> files() const override { return {file}; }
  void start() override { site_.tables.begin(file, observables_header(site_.sim.scene())); }
  bool write(const StepTaken& step) override {
    if (site_.sim.scene().output.statistics) {
      include(interval(), loads(site_.sim, site_.sim.wall_forces(before_)),
              step.after - step.before);
      before_ = site_.sim.moment();
    }
    if (!site_.schedule.observe_after(step)) return false;
    write_end();
    interval() = {};
    return true;
  }
  void write_end() override {
    RunRecord& record = site_.record;
    record.wall_forces = site_.sim.wall_forces(record.observed);
    record.flows = site_.sim.flows(record.observed);
    record.observed = site_.sim.moment();
    site_.tables.add(file,
                     observables_line(site_.sim, record.wall_forces, record.flows, interval()));
  }

 private:
  static constexpr const char* file = "observables.csv";
  IntervalRecord& interval() { return site_.record.intervals[file]; }
  RunSite site_;
  Simulation::Moment before_;  // the last step
};

/// bodies.csv, and in 3D the mesh of each body. It has rows at the times of the observables and of
/// the data files, so that every data file can be drawn with its bodies.
class BodyTable final : public Output {
 public:
  explicit BodyTable(const RunSite& site) : site_(site) {}
  const char* name() const override { return "bodies"; }
  std::vector<std::string> files() const override {
    std::vector<std::string> all{file};
    for (std::size_t k = 0; k < meshes(); ++k) all.push_back(mesh_file(k));
    return all;
  }
  void start() override {
    const Scene& scene = site_.sim.scene();
    site_.tables.begin(file, body_header(scene));
    for (std::size_t k = 0; k < meshes(); ++k)
      site_.folder.write(mesh_file(k),
                         encode_obj(body_mesh(scene.body[k]), body_shape(scene.body[k]).center,
                                    scene.body_name(k)));
  }
  bool shows_between(double from, double to) const override {
    return site_.schedule.data().frames_between(from, to);
  }
  bool write(const StepTaken& step) override {
    auto times = site_.schedule.data().frames_in(step);
    if (site_.schedule.observe_after(step) && (times.empty() || times.back() != step.after))
      times.push_back(step.after);
    for (const double time : times) add(time);
    return !times.empty() && times.back() == step.after;
  }
  void write_end() override { add(site_.sim.time()); }

 private:
  void add(double time) {
    site_.tables.add(file, body_lines(*site_.frames.at(time), site_.sim.scene()));
  }
  static constexpr const char* file = "bodies.csv";
  static std::string mesh_file(std::size_t k) { return fmt::format("bodies/body_{:03}.obj", k); }
  std::size_t meshes() const {
    const Scene& scene = site_.sim.scene();
    return scene.dimension() == 3 ? scene.body.size() : 0;
  }
  RunSite site_;
};

/// probes/NAME.csv: the readings of each probe.
class ProbeTables final : public Output {
 public:
  explicit ProbeTables(const RunSite& site) : site_(site), probes_(site.sim.scene()) {}
  const char* name() const override { return "probes"; }
  std::vector<std::string> files() const override {
    std::vector<std::string> all;
    for (std::size_t k = 0; k < probes_.size(); ++k) all.push_back(file(k));
    return all;
  }
  void start() override {
    for (std::size_t k = 0; k < probes_.size(); ++k) site_.tables.begin(file(k), header(k));
  }
  bool write(const StepTaken& step) override {
    std::vector<std::vector<Probes::Reading>> readings;
    if (statistics()) {
      readings = probes_.measure(site_.sim);
      for (std::size_t k = 0; k < probes_.size(); ++k)
        include(interval(k), numbers(readings[k]), step.after - step.before);
    }
    for (std::size_t k = 0; k < probes_.size(); ++k) {
      if (!site_.schedule.probe_after(k, step)) continue;
      if (readings.empty()) readings = probes_.measure(site_.sim);
      add_rows(k, step.after, readings[k]);
    }
    return true;
  }

 private:
  std::string file(std::size_t k) const { return probe_file(site_.sim.scene(), k); }
  bool statistics() const { return site_.sim.scene().output.statistics; }
  IntervalRecord& interval(std::size_t k) { return site_.record.intervals[file(k)]; }
  static std::vector<double> numbers(const std::vector<Probes::Reading>& readings) {
    std::vector<double> all;
    for (const Probes::Reading& r : readings)
      all.insert(all.end(), r.values.begin(), r.values.end());
    return all;
  }
  std::string header(std::size_t k) const {
    std::string line = probes_.header(k);
    if (!statistics()) return line;
    line.pop_back();
    for (const Probes::Quantity& q : probes_.quantities(k))
      line += interval_columns(q.name, q.unit);
    return line + "\n";
  }
  void add_rows(std::size_t k, double time, const std::vector<Probes::Reading>& readings) {
    std::string lines;
    std::size_t first = 0;
    for (const Probes::Reading& reading : readings) {
      lines += Probes::line(time, reading);
      if (statistics()) {
        lines.pop_back();
        lines += interval_cells(interval(k), first, reading.values.size()) + "\n";
      }
      first += reading.values.size();
    }
    site_.tables.add(file(k), lines);
    site_.record.intervals.erase(file(k));
  }
  RunSite site_;
  Probes probes_;
};

/// percentiles.csv: the ranges of colours. It has a row after each step in which observables,
/// pictures or data files are due, so that each can be drawn with the same colours later.
class PercentileTable final : public Output {
 public:
  explicit PercentileTable(const RunSite& site) : site_(site) {}
  const char* name() const override { return "percentiles"; }
  std::vector<std::string> files() const override { return {percentile_file}; }
  void start() override {
    site_.tables.begin(percentile_file, percentile_header(site_.sim.scene()));
  }
  /// A table that is missing begins again, and the colours with it. A run of an older version had
  /// none.
  std::vector<Diagnostic> resume() override {
    if (!site_.record.tables.contains(percentile_file)) start();
    const auto file = site_.folder.path() / percentile_file;
    std::error_code ec;
    if (std::filesystem::is_regular_file(file, ec))
      site_.ranges = RangesByStep(file, site_.sim.scene()).all();
    return {};
  }
  bool write(const StepTaken& step) override {
    const Schedule& schedule = site_.schedule;
    const bool due = schedule.observe_after(step) || !schedule.frame().frames_in(step).empty() ||
                     !schedule.data().frames_in(step).empty();
    if (due) write_end();
    return due;
  }
  void write_end() override {
    const Simulation& sim = site_.sim;
    const ColorRanges now = percentiles_of(sim.scene(), sim.frame());
    const std::string line =
        percentile_line(sim.scene().dimension(), sim.steps_done(), sim.time(), now);
    if (line.empty()) return;
    site_.tables.add(percentile_file, line);
    include(site_.ranges, now);
  }

 private:
  RunSite site_;
};

/// frames/frame_0000.png: pictures. The tables on disk keep up with them.
class Pictures final : public Output {
 public:
  explicit Pictures(const RunSite& site) : site_(site) {}
  const char* name() const override { return "frames"; }
  std::vector<std::string> files() const override {
    std::vector<std::string> all;
    for (std::int64_t k = 0; k < site_.schedule.frames(); ++k) all.push_back(file(k));
    return all;
  }
  bool shows_between(double from, double to) const override {
    return site_.schedule.frame().frames_between(from, to);
  }
  bool write(const StepTaken& step) override {
    const auto due = site_.schedule.frame().frames_in(step);
    for (const double time : due) add(time);
    return !due.empty() && due.back() == step.after;
  }
  void write_end() override { add(site_.sim.time()); }

 private:
  void add(double time) {
    auto& times = site_.record.series[name()].times;
    site_.background.add([site = site_, k = std::int64_t(times.size()),
                          frame = site_.frames.at(time), ranges = site_.ranges] {
      site.folder.write_more(file(k), encode_png(draw(site.sim.scene(), *frame, ranges)));
    });
    times.push_back(time);
    site_.tables.flush();
  }
  static std::string file(std::int64_t k) { return fmt::format("frames/frame_{:04}.png", k); }
  RunSite site_;
};

/// data/frame_0000.*: the particles in the formats that the scene asks for.
class DataFiles final : public Output {
 public:
  explicit DataFiles(const RunSite& site) : site_(site) {}
  const char* name() const override { return "data"; }
  std::vector<std::string> files() const override {
    return data_files(site_.sim.scene(), site_.schedule.data_frames());
  }
  bool shows_between(double from, double to) const override {
    return site_.schedule.data().frames_between(from, to);
  }
  bool write(const StepTaken& step) override {
    const auto due = site_.schedule.data().frames_in(step);
    for (const double time : due) add(time);
    return !due.empty() && due.back() == step.after;
  }
  void write_end() override { add(site_.sim.time()); }

 private:
  void add(double time) {
    auto& times = site_.record.series[name()].times;
    times.push_back(time);
    site_.tables.flush();  // bodies.csv has the bodies of a data file before the file exists
    site_.background.add([site = site_, times, frame = site_.frames.at(time)] {
      const Scene& scene = site.sim.scene();
      write_files(site, times, &data_file, table_of(*frame, DataFields(scene)), pvd_file);
      if (scene.whitewater)
        write_files(site, times, &whitewater_file,
                    whitewater_table(*frame, DataFields(scene).pscale), whitewater_pvd_file);
    });
  }
  /// The last files of a series, which has these times.
  static void write_files(const RunSite& site, const std::vector<double>& times,
                          std::string (*file)(DataFormat, std::int64_t), const PointTable& table,
                          const char* series) {
    const Scene::Output& output = site.sim.scene().output;
    const auto k = std::int64_t(times.size()) - 1;
    for (const DataFormat format : output.data)
      site.folder.write_more(file(format, k), encode_points(format, table));
    if (!has_time_series(output)) return;
    std::vector<std::string> names;
    for (std::int64_t n = 0; n <= k; ++n) names.push_back(file(DataFormat::vtp, n));
    site.folder.write(series, encode_pvd(times, names));
  }
  static bool has_time_series(const Scene::Output& output) {
    return std::find(output.data.begin(), output.data.end(), DataFormat::vtp) != output.data.end();
  }
  RunSite site_;
};

}  // namespace

std::vector<std::unique_ptr<Output>> outputs_of(const RunSite& site) {
  const Scene& scene = site.sim.scene();
  std::vector<std::unique_ptr<Output>> all;
  all.push_back(std::make_unique<Observables>(site));
  if (!scene.body.empty()) all.push_back(std::make_unique<BodyTable>(site));
  if (!scene.probe.empty()) all.push_back(std::make_unique<ProbeTables>(site));
  all.push_back(std::make_unique<PercentileTable>(site));
  all.push_back(std::make_unique<Pictures>(site));
  if (!scene.output.data.empty()) all.push_back(std::make_unique<DataFiles>(site));
  if (scene.surface) all.push_back(std::make_unique<SurfaceOutput>(site));
  if (const auto& video = site.record.video)
    all.push_back(std::make_unique<VideoOutput>(site, *video));
  return all;
}

}  // namespace freshet
