// SPDX-License-Identifier: MIT
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <chrono>
#include <cmath>
#include <limits>
#include <optional>

#include "core/input_file.h"
#include "freshet/measure.h"
#include "io/folder.h"
#include "io/surface_vtp.h"
#include "run/finished_run.h"
#include "run/frame_gaps.h"
#include "run/measured_tables.h"
#include "scene/check/probe_warnings.h"
#include "scene/keys/measured_scene.h"
#include "scene/model/setup.h"
#include "sim/surfaces.h"

namespace freshet {
namespace {

namespace fs = std::filesystem;

/// The run's scene with the probes and counters to measure.
Scene scene_to_measure(const MeasureOptions& options, const Scene& run) {
  if (options.probes.empty())
    return scene_of_run(
        options.run, options.overrides,
        {{"probe", "counter"},
         "the run is over: only keys of [probe] and [counter] can change what is measured; run the "
         "scene again for others"});
  constexpr InputFile file{.noun = "file of probes",
                           .remedy = "name a file with [[probe]] tables (*.toml)",
                           .may_be_empty = true,
                           .largest = 16u << 20};
  return measured_scene(run, read_input(options.probes, file), options.probes.string(),
                        options.overrides);
}

/// Throws if a data file lacks a field that a measurement needs.
class Needs {
 public:
  Needs(const Scene& scene, bool loads) {
    bool fluid = loads;
    for (const Scene::Probe& p : scene.probe) fluid = fluid || p.kind != ProbeKind::surface;
    if (fluid) fields_ = {"velocity", "density", "pressure"};
    if (!scene.counter.empty()) fields_.emplace_back("id");
  }
  void check(const DataFields& stored, const fs::path& file) const {
    std::vector<std::string> missing;
    for (const std::string& field : fields_)
      if (!(field == "velocity"   ? stored.velocity
            : field == "density"  ? stored.density
            : field == "pressure" ? stored.pressure
                                  : stored.id))
        missing.push_back(field);
    if (missing.empty()) return;
    throw Error(Error::Kind::scene, file.string(),
                fmt::format("this data file has no {}, which this measurement needs; add \"{}\" to "
                            "output.fields and run the scene again",
                            fmt::join(missing, " and no "), fmt::join(missing, "\", \"")));
  }

 private:
  std::vector<std::string> fields_;
};

/// The files of a measurement: STEM.csv, and others in the folder STEM.
class MeasuredFiles {
 public:
  MeasuredFiles(const MeasureOptions& options, bool has_others)
      : folder_(options.output.empty() ? options.run : made_folder(parent(options.output))),
        stem_(stem(options)) {
    const auto taken = [&] {
      return folder_.holds(stem_ + ".csv") || (has_others && folder_.holds(stem_));
    };
    if (options.overwrite || !taken()) return;
    if (!options.output.empty())
      throw Error(Error::Kind::scene, (folder_.path() / (stem_ + ".csv")).string(),
                  fmt::format("{} exists; `overwrite` replaces it, or choose another `output`",
                              folder_.holds(stem_ + ".csv")
                                  ? "this table"
                                  : fmt::format("the folder {} of this table", stem_)),
                  {"overwrite", "output"});
    const std::string first = stem_;
    for (int k = 2; taken(); ++k) stem_ = fmt::format("{}-{}", first, k);
  }
  void write_table(const std::string& bytes) { write(stem_ + ".csv", bytes, files_.begin()); }
  void write_other(const std::string& name, const std::string& bytes) {
    folder_.make_folder_of(stem_ + "/" + name);
    write(stem_ + "/" + name, bytes, files_.end());
  }
  std::vector<fs::path> take() { return std::move(files_); }

 private:
  static fs::path parent(const fs::path& file) {
    return file.has_parent_path() ? file.parent_path() : fs::path(".");
  }
  static std::string stem(const MeasureOptions& options) {
    if (options.output.empty()) return "measured";
    if (options.output.extension() == ".csv") return options.output.stem().string();
    throw Error(Error::Kind::scene, options.output.string(),
                "the output is a table; name it *.csv, as in measured.csv");
  }
  void write(const std::string& name, const std::string& bytes,
             std::vector<fs::path>::const_iterator at) {
    folder_.write(name, bytes);
    files_.insert(at, folder_.path() / name);
  }

  Folder folder_;
  std::string stem_;
  std::vector<fs::path> files_;
};

/// The load on surfaces, as a time series.
class SurfaceFiles {
 public:
  explicit SurfaceFiles(const Scene& scene) : surfaces_(scene) {}
  void write(const Simulation& sim, const BoundaryForces& boundary, std::int64_t number,
             MeasuredFiles& files) {
    const std::string name = fmt::format("surfaces/surface_{:04}.vtp", number);
    files.write_other(
        name, encode_surface(surfaces_.load(boundary, sim.bodies()), sim.time(), sim.steps_done()));
    times_.push_back(sim.time());
    names_.push_back(name);
  }
  void finish(MeasuredFiles& files) const {
    files.write_other("surfaces/surfaces.pvd", encode_pvd(times_, names_));
  }

 private:
  Surfaces surfaces_;
  std::vector<double> times_;
  std::vector<std::string> names_;
};

/// Measures the frames of a run one by one.
class Measurement {
 public:
  Measurement(const MeasureOptions& options, const Scene& scene)
      : loads_(options.forces || options.surfaces),
        scene_(scene),
        sim_(without_counters(scene), options.execution),
        probes_(sim_.scene()),
        flows_(scene),
        tables_(scene, probes_, loads_),
        needs_(scene, loads_) {
    if (options.surfaces) surfaces_.emplace(sim_.scene());
  }

  void add(const FrameFile& file, const FinishedRun& run, MeasuredFiles& files) {
    DataFields stored;
    const Frame frame = run.read(file, &stored);
    needs_.check(stored, file.path);
    show(frame, file.path);
    FrameMeasures measures{file.number, frame.time, probes_.measure(sim_), {}, {}};
    if (!scene_.counter.empty()) measures.flows = flows_.advance(frame);
    if (loads_) {
      const BoundaryForces boundary = sim_.boundary_forces();
      measures.forces = forces(boundary);
      if (surfaces_) surfaces_->write(sim_, boundary, file.number, files);
    }
    tables_.add(measures);
  }
  void finish(MeasuredFiles& files) const {
    for (const auto& [name, table] : tables_.of_probes()) files.write_other(name + ".csv", table);
    if (surfaces_) surfaces_->finish(files);
    files.write_table(tables_.table());
  }

 private:
  /// The counters of the run would only count steps.
  static Scene without_counters(Scene scene) {
    scene.counter.clear();
    return scene;
  }
  void show(const Frame& frame, const fs::path& file) try {
    sim_.show(frame);
  } catch (const Error& error) {
    throw Error(error.kind(), file.string(), error.diagnostics().front().message);
  }
  /// By wall, then by body. Reflecting walls have forces during steps only.
  std::vector<Vector> forces(const BoundaryForces& boundary) const {
    std::vector<Vector> all = forces_on_parts(scene_, boundary), walls = sim_.wall_forces();
    const auto sides = std::size_t(2 * scene_.dimension());
    for (std::size_t w = 0; w < walls.size(); ++w) {
      const WallMethod method =
          w < sides ? scene_.side_method(int(w)) : scene_.wall_method(w - sides);
      all[w] = walls[w];
      if (method == WallMethod::reflection && !(w < sides && scene_.periodic(int(w / 2))))
        all[w].assign(all[w].size(), std::numeric_limits<double>::quiet_NaN());
    }
    return all;
  }

  bool loads_;
  const Scene& scene_;
  Simulation sim_;
  Probes probes_;
  FrameFlows flows_;
  MeasuredTables tables_;
  Needs needs_;
  std::optional<SurfaceFiles> surfaces_;
};

bool needs_folder(const Scene& scene, bool surfaces) {
  for (const Scene::Probe& p : scene.probe)
    if (p.kind == ProbeKind::line || p.kind == ProbeKind::plane) return true;
  return surfaces;
}

void refuse_nothing(const MeasureOptions& options, const Scene& scene) {
  if (!scene.probe.empty() || !scene.counter.empty() || options.forces || options.surfaces) return;
  const bool own = options.probes.empty();
  throw Error(Error::Kind::scene, own ? options.run.string() : options.probes.string(),
              own ? "the scene of this run has no probes and no counters; name a file of [[probe]] "
                    "tables with `probes`, or choose `forces` or `surfaces`"
                  : "there is no [[probe]] and no [[counter]] in this file; add one, or choose "
                    "`forces` or `surfaces`",
              {"probes", "forces", "surfaces"});
}

void warn_of(const MeasureOptions& options, std::vector<Diagnostic> warnings) {
  if (options.warn && !warnings.empty()) options.warn(warnings);
}

}  // namespace

MeasureReport measure(const MeasureOptions& options) {
  const auto start = std::chrono::steady_clock::now();
  const Scene own = scene_of_run(options.run, {}, {{}, ""});
  const Scene scene = with_defaults(scene_to_measure(options, own));
  refuse_nothing(options, scene);
  const FinishedRun run(options.run, own, "measure");
  MeasuredFiles files(options, needs_folder(scene, options.surfaces));
  warn_of(options, probe_warnings(scene));
  warn_of(options, gaps_in(run.files(),
                           "the table has no rows for them, and flows are those between the "
                           "others"));
  Measurement measurement(options, scene);
  MeasureReport report;
  for (const FrameFile& file : run.files()) {
    measurement.add(file, run, files);
    ++report.frames;
    report.interrupted =
        options.after_frame && !options.after_frame(report.frames, run.files().size());
    if (report.interrupted) break;
  }
  measurement.finish(files);
  report.files = files.take();
  report.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  return report;
}

}  // namespace freshet
