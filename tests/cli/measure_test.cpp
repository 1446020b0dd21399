// SPDX-License-Identifier: MIT
/// `freshet measure` measures a finished run from its data files.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstring>

#include "cli/files.h"
#include "cli/process.h"
#include "io/frame_files.h"
#include "run/table.h"
#include "sim/forced.h"

namespace freshet::test {
namespace {

constexpr const char* gauges =
    "[[probe]]\nname = \"inside\"\nat = [0.52, 0.2]\n"
    "[[probe]]\nname = \"level\"\nkind = \"surface\"\nfrom = [0.5, 0]\nto = [0.5, 0.8]\n"
    "[[probe]]\nname = \"side\"\nkind = \"wall\"\nfrom = [1.0, 0.05]\nto = [1.0, 0.25]\n"
    "[[probe]]\nname = \"across\"\nkind = \"line\"\nfrom = [0.1, 0.1]\nto = [0.9, 0.3]\ncount = "
    "7\n";

struct Tank {
  const char *solver, *walls;
};
void PrintTo(const Tank& t, std::ostream* out) { *out << t.solver << ", " << t.walls; }

/// Water 0.5 m deep in a tank 1 m wide, with data files and rows of tables after every 25 steps.
std::string tank(const Tank& t, const std::string& more = "") {
  return std::string(
             "[domain]\nmax = [1.0, 0.8]\n[particles]\nspacing = 0.05\n[fluid]\nmin = [0, "
             "0]\nmax = [1, 0.5]\npressure = \"hydrostatic\"\n[walls]\nmethod = \"") +
         t.walls + "\"\nslip = \"free_slip\"\n[solver]\nname = \"" + t.solver + "\"\n" +
         (std::string(t.solver) == "delta_sph" ? "sound_speed = 30\n" : "") +
         "[time]\nend = 0.2\nstep = 0.0005\n[output]\nframe_every_steps = 400\ndata_every_steps = "
         "25\nobservables_every_steps = 25\n[picture]\nwidth = 40\n" +
         more;
}

/// A run in a folder, and what `measure` makes of it.
class MeasuredRun {
 public:
  explicit MeasuredRun(const std::string& scene) {
    write_text(folder_ / "scene.toml", scene);
    const auto r =
        freshet({"run", (folder_ / "scene.toml").string(), "--output", path().string(), "--quiet"});
    EXPECT_EQ(r.code, 0) << r.err;
  }
  fs::path path() const { return folder_ / "run"; }
  fs::path operator/(const std::string& name) const { return path() / name; }
  /// A file beside the run.
  std::string file(const std::string& name, const std::string& text) const {
    write_text(folder_ / name, text);
    return (folder_ / name).string();
  }
  ProcessResult measure(std::vector<std::string> more = {}) const {
    more.insert(more.begin(), {"measure", path().string()});
    return freshet(more);
  }
  Table measured(std::vector<std::string> more = {}) const {
    more.insert(more.end(), {"--overwrite", "--quiet"});
    const auto r = measure(more);
    EXPECT_EQ(r.code, 0) << r.err;
    EXPECT_EQ(r.err, "");
    return read_table(*this / "measured.csv");
  }

 private:
  TemporaryFolder folder_;
};

std::vector<double> column(const Table& table, const std::string& name) {
  const Column* found = table.find(name);
  EXPECT_NE(found, nullptr) << name;
  return found ? found->numbers : std::vector<double>();
}

double scale_of(const std::vector<double>& values) {
  double most = 1e-9;
  for (const double v : values) most = std::max(most, std::abs(v));
  return most;
}

/// The columns must agree in the rows that the run's own table has: one after the last step is
/// missing in those of probes.
void expect_same(const Table& own, const std::string& own_name, const Table& measured,
                 const std::string& name, double tolerance) {
  const auto a = column(own, own_name), b = column(measured, name), ta = column(own, "time"),
             tb = column(measured, "time");
  ASSERT_GE(ta.size(), 2u);
  ASSERT_LE(ta.size(), tb.size());
  for (std::size_t k = 0; k < a.size(); ++k) EXPECT_EQ(ta[k], tb[k]);
  for (std::size_t k = 0; k < a.size(); ++k)
    EXPECT_NEAR(a[k], b[k], tolerance * scale_of(a)) << name << " at " << ta[k] << " s";
}

/// The arrays of a surface file that Freshet wrote.
struct SurfaceFile {
  std::vector<float> points, normal, traction, pressure, area;
  std::vector<std::int32_t> part;

  explicit SurfaceFile(const fs::path& file) {
    const std::string bytes = read_text(file);
    read(bytes, "Points", points);
    read(bytes, "normal", normal);
    read(bytes, "traction", traction);
    read(bytes, "pressure", pressure);
    read(bytes, "area", area);
    read(bytes, "part", part);
  }

 private:
  template <class T>
  static void read(const std::string& bytes, const std::string& name, std::vector<T>& values) {
    const auto at = bytes.find("Name=\"" + name + "\""), offset = bytes.find("offset=\"", at);
    const auto data = bytes.find("_", bytes.find("<AppendedData"));
    ASSERT_NE(at, std::string::npos) << name;
    const char* from = bytes.data() + data + 1 + std::stoul(bytes.substr(offset + 8));
    std::uint64_t size = 0;
    std::memcpy(&size, from, sizeof size);
    values.resize(size / sizeof(T));
    std::memcpy(values.data(), from + sizeof size, size);
  }
};

class MeasureTank : public testing::TestWithParam<Tank> {
  void SetUp() override {
    if (!compiled(GetParam().solver)) GTEST_SKIP() << "not compiled in this build";
  }
};

TEST_P(MeasureTank, ProbesHaveTheValuesOfTheRun) {
  const MeasuredRun run(tank(GetParam(), gauges));
  const Table measured = run.measured();
  EXPECT_EQ(17u, measured.rows);
  for (const char* probe : {"inside", "level"}) {
    const Table own = read_table(run / "probes" / (std::string(probe) + ".csv"));
    for (const Column& c : own.columns)
      if (c.name != "time" && c.name != "x" && c.name != "y")
        expect_same(own, c.name, measured, std::string(probe) + ": " + c.name, 1e-5);
  }
  const Table own = read_table(run / "probes/across.csv");
  const Table across = read_table(run / "measured/across.csv");
  ASSERT_EQ(16u * 7, own.rows);
  ASSERT_EQ(17u * 7, across.rows);
  for (const char* name : {"x", "y", "fraction", "velocity x", "density", "pressure"}) {
    const auto a = column(own, name), b = column(across, name);
    for (std::size_t k = 0; k < a.size(); ++k) EXPECT_NEAR(a[k], b[k], 1e-5 * scale_of(a)) << name;
  }
}

TEST_P(MeasureTank, WallsHaveTheLoadsOfTheRun) {
  const MeasuredRun run(tank(GetParam(), gauges));
  const Table measured = run.measured({"--forces"});
  const Table side = read_table(run / "probes/side.csv");
  const Table observables = read_table(run / "observables.csv");
  // the pressure of adami2012 is extrapolated from places after the step, not within it
  const double tolerance = GetParam().walls == std::string("adami2012") ? 5e-3 : 1e-5;
  expect_same(side, "traction x", measured, "side: traction x", tolerance);
  for (const char* name : {"force on x_max x", "force on y_min y"})
    expect_same(observables, name, measured, name, tolerance);
}

/// The pressure on the middle of the floor.
double on_the_floor(const SurfaceFile& surface) {
  double sum = 0, count = 0;
  for (std::size_t k = 0; k < surface.part.size(); ++k) {
    const float x = surface.points[3 * k], y = surface.points[3 * k + 1];
    if (surface.part[k] != 2 || x < 0.1 || x > 0.9) continue;  // y_min
    EXPECT_EQ(y, 0);
    EXPECT_EQ(surface.normal[3 * k + 1], 1);
    EXPECT_NEAR(surface.pressure[k], -surface.traction[3 * k + 1], 1e-3);
    sum += surface.pressure[k];
    ++count;
  }
  EXPECT_EQ(16, count);
  return sum / count;
}

TEST_P(MeasureTank, NewProbesAndSurfacesHaveHydrostaticPressure) {
  std::string scene = tank(GetParam());
  const auto put = [&](const std::string& old, const std::string& now) {
    scene.replace(scene.find(old), old.size(), now);
  };
  put("end = 0.2\nstep = 0.0005", "end = 2\nstep = \"adaptive\"\nstep_max = 0.002");
  put("frame_every_steps = 400\ndata_every_steps = 25\nobservables_every_steps = 25",
      "frame_every = 2\ndata_every = 0.01");
  put("[walls]\n", "[walls]\ny_max = \"open\"\n");
  const MeasuredRun run(scene);
  const std::string file =
      run.file("new.toml",
               "[probe]\nname = \"low\"\nkind = \"wall\"\nfrom = [1.0, 0.05]\nto = [1.0, 0.15]\n");
  const Table measured = run.measured({"--probes", file, "--surfaces"});
  const auto low = column(measured, "low: traction x");
  ASSERT_GE(low.size(), 201u);  // an adaptive run may end a little after 2 s
  double side = 0, floor = 0;
  for (std::size_t k = 101; k <= 200; ++k) {
    side += low[k] / 100;
    floor +=
        on_the_floor(SurfaceFile(run / fmt::format("measured/surfaces/surface_{:04}.vtp", k))) /
        100;
  }
  EXPECT_NEAR(1, side / (9810 * 0.4), 0.05);
  EXPECT_NEAR(1, floor / (9810 * 0.5), 0.05);
}

INSTANTIATE_TEST_SUITE_P(Solvers, MeasureTank,
                         testing::Values(Tank{"delta_sph", "adami2012"},
                                         Tank{"delta_sph", "akinci2012"},
                                         Tank{"wcsph", "akinci2012"}, Tank{"dfsph", "akinci2012"},
                                         Tank{"iisph", "akinci2012"}));

/// Water that falls over a brink, with a counter, every 10 steps.
std::string falling_column(const std::string& more = "") {
  return "[domain]\nmax = [1.0, 0.6]\n[particles]\nspacing = 0.04\n[fluid]\nmin = [0, 0]\nmax = "
         "[0.4, 0.5]\n[solver]\nname = \"wcsph\"\nsound_speed = 30\n[time]\nend = 0.4\nstep = "
         "0.0004\n[[counter]]\nname = \"gate\"\ncenter = [0.5, 0]\ndirection = [1, 0]\n"
         "[output]\nframe_every_steps = 1000\ndata_every_steps = 100\nobservables_every_steps = "
         "100\n" +
         more + "[picture]\nwidth = 40\n";
}

class Measure : public testing::Test {
 protected:
  void SetUp() override {
    if (!compiled("wcsph")) GTEST_SKIP() << "not compiled in this build";
  }
  static void expect_refused(const ProcessResult& r, const std::string& words) {
    EXPECT_EQ(r.code, 2);
    EXPECT_TRUE(contains(r.err, words)) << r.err;
  }
};

TEST_F(Measure, CountersCountWhatCrossesThemBetweenFrames) {
  const MeasuredRun run(falling_column());
  const Table own = read_table(run / "observables.csv"), measured = run.measured();
  EXPECT_GT(column(own, "volume through gate").back(), 0.01);
  for (const char* name : {"volume through gate", "flow through gate"})
    expect_same(own, name, measured, name, 1e-12);
  const std::string file =
      run.file("new.toml",
               "counter = [{ name = \"back\", center = [0.5, 0], direction = [-1, 0] }, { name = "
               "\"slit\", center = [0.5, 0.05], direction = [1, 0], width = 0.1 }]\n");
  const Table fresh = run.measured({"--probes", file});
  EXPECT_EQ(fresh.find("volume through gate"), nullptr);
  EXPECT_NEAR(column(measured, "volume through gate").back(),
              -column(fresh, "volume through back").back(), 1e-12);
  const double slit = column(fresh, "volume through slit").back();
  EXPECT_GT(slit, 0);
  EXPECT_LT(slit, column(measured, "volume through gate").back());
}

TEST_F(Measure, SetsProbesOnTheCommandLine) {
  const MeasuredRun run(falling_column());
  const Table measured = run.measured({"--set", "probe.at=[0.2, 0.1]", "--set", "probe.name=here"});
  EXPECT_NEAR(1, column(measured, "here: fraction").front(), 0.05);
  expect_refused(run.measure({"--set", "time.end=3"}),
                 "--set time.end: error: the run is over: only keys of [probe] and [counter]");
}

TEST_F(Measure, ReadsTheProbesOfAScene) {
  const MeasuredRun run(falling_column());
  const char* probe = "[[probe]]\nname = \"there\"\nat = [0.2, 0.1]\n";
  const std::string scene = run.file("scene.toml", falling_column() + probe);
  EXPECT_NEAR(1, column(run.measured({"--probes", scene}), "there: fraction").front(), 0.05);
}

TEST_F(Measure, RejectsInvalidFilesOfProbes) {
  const MeasuredRun run(falling_column());
  const auto expect_error = [&](const std::string& text, const std::string& place,
                                const std::string& words) {
    const std::string file = run.file("bad.toml", text);
    expect_refused(run.measure({"--probes", file}), file + place + ": error: " + words);
  };
  expect_error("[[probe]]\nat = [0.1, 0.1]\nradius = 2\n", ":3:1", "unknown key probe.radius");
  expect_error("[[probe]]\nat = [0.1, 0.1, 0]\n", ":2:6", "probe.at is an array of 3 values");
  expect_error("[[probe]]\nkind = \"line\"\nfrom = [0, 0]\n", ":1:1", "probe.to is missing");
  expect_error("[[probe]]\nat = [0.1, 0.1]\nevery = 0.1\n", ":3:9",
               "probe.every is not used; a finished run is measured at each of its data files");
  expect_error("[[fluid]]\nmin = [0, 0]\n", ":1:3",
               "unknown key fluid; known here: counter, probe");
  expect_error("[[counter]]\ncenter = [0.5, 0]\ndirection = [0, 0]\n", ":3:13",
               "counter.direction is 0");
  expect_error("[[probe\n", ":1:8", "");
  expect_error("", "", "there is no [[probe]] and no [[counter]] in this file");
  EXPECT_FALSE(fs::exists(run / "measured.csv"));
  const MeasuredRun bare(tank({"wcsph", "akinci2012"}));
  expect_refused(bare.measure(), "the scene of this run has no probes and no counters");
}

TEST_F(Measure, NamesTheFieldsThatDataFilesLack) {
  const MeasuredRun run(falling_column("fields = [\"velocity\"]\n"));
  const std::string point = run.file("point.toml", "[probe]\nat = [0.2, 0.1]\n");
  expect_refused(run.measure({"--probes", point}),
                 "frame_0000.vtp: error: this data file has no density and no pressure, which "
                 "this measurement needs; add \"density\", \"pressure\" to output.fields");
  expect_refused(run.measure(),
                 "this data file has no id, which this measurement needs; add "
                 "\"id\" to output.fields and run the scene again");
  const std::string level =
      run.file("level.toml", "[[probe]]\nkind = \"surface\"\nfrom = [0.2, 0]\nto = [0.2, 0.6]\n");
  EXPECT_NEAR(0.5, column(run.measured({"--probes", level}), "probe_0: distance").front(), 0.04);
}

TEST_F(Measure, NamesDamagedAndMissingDataFiles) {
  const MeasuredRun run(falling_column());
  const fs::path file = run / "data/frame_0003.vtp";
  const std::string whole = read_text(file);
  write_text(file, whole.substr(0, whole.size() / 2));
  expect_refused(run.measure(), file.string() + ": error: ");
  EXPECT_FALSE(fs::exists(run / "measured.csv"));
  fs::remove(file);
  const auto r = run.measure();
  EXPECT_EQ(r.code, 0) << r.err;
  EXPECT_TRUE(contains(r.err, "warning: data files are missing: 0003; the table has no rows"))
      << r.err;
  EXPECT_EQ(10u, read_table(run / "measured.csv").rows);
  fs::remove_all(run / "data");
  expect_refused(run.measure(), "this run wrote no data to measure");
  fs::remove(run / "scene.toml");
  expect_refused(run.measure(), "no run is in this folder");
}

TEST_F(Measure, NeverReplacesATableWithoutOverwrite) {
  const MeasuredRun run(falling_column(
      "[[probe]]\nname = \"across\"\nkind = \"line\"\nfrom = [0.1, 0.1]\nto = [0.9, 0.3]\n"));
  ASSERT_EQ(0, run.measure().code);
  const std::string first = read_text(run / "measured.csv");
  write_text(run / "measured.csv", "mine");
  ASSERT_EQ(0, run.measure().code);
  EXPECT_EQ("mine", read_text(run / "measured.csv"));
  EXPECT_EQ(first, read_text(run / "measured-2.csv"));
  EXPECT_TRUE(fs::exists(run / "measured-2/across.csv"));
  ASSERT_EQ(0, run.measure({"--overwrite"}).code);
  EXPECT_EQ(first, read_text(run / "measured.csv"));
  const std::string named = (run / "new/table.csv").string();
  ASSERT_EQ(0, run.measure({"--output", named}).code);
  EXPECT_EQ(first, read_text(named));
  expect_refused(run.measure({"--output", named}),
                 named + ": error: this table exists; --overwrite");
  ASSERT_EQ(0, run.measure({"--output", named, "--overwrite"}).code);
  expect_refused(run.measure({"--output", (run / "table.txt").string()}), "name it *.csv");
}

TEST_F(Measure, SurfacesOfABodyAddUpToTheForceOnIt) {
  const MeasuredRun run(tank({"wcsph", "akinci2012"},
                             "[[body]]\nname = \"ball\"\nshape = \"sphere\"\ncenter = [0.5, "
                             "0.25]\nradius = 0.1\nmotion = \"fixed\"\n"));
  const Table measured = run.measured({"--surfaces"});
  const SurfaceFile surface(run / "measured/surfaces/surface_0016.vtp");
  double lift = 0;
  for (std::size_t k = 0; k < surface.part.size(); ++k) {
    if (surface.part[k] != 4) continue;  // after the four sides
    const double x = surface.points[3 * k] - 0.5, y = surface.points[3 * k + 1] - 0.25;
    EXPECT_NEAR(0.1, std::hypot(x, y), 1e-5);
    EXPECT_NEAR(surface.normal[3 * k], x / 0.1, 1e-4);
    lift += surface.traction[3 * k + 1] * surface.area[k];
  }
  const double weight = 9810 * 3.14159 * 0.01;  // of the water that it displaces
  EXPECT_NEAR(lift, column(measured, "force on ball y").back(), 1e-4 * weight);
  const Table bodies = read_table(run / "bodies.csv");
  const auto own = column(bodies, "force y");
  EXPECT_NEAR(own.back(), lift, 0.02 * weight);
}

TEST_F(Measure, ReflectingWallsHaveNoForceInAFrame) {
  std::string scene = falling_column();
  const std::string solver = "[solver]";
  scene.replace(scene.find(solver), solver.size(),
                "[walls]\nmethod = \"akinci2012\"\nx_min = \"reflection\"\n[solver]");
  const Table measured = MeasuredRun(scene).measured({"--forces"});
  EXPECT_TRUE(std::isnan(column(measured, "force on x_min x").back()));
  EXPECT_LT(column(measured, "force on y_min y").back(), -100);
}

TEST_F(Measure, SurfacesAddUpToTheForceOnEachWall) {
  const MeasuredRun run(tank({"wcsph", "akinci2012"}));
  const Table forces = run.measured({"--surfaces"});
  const fs::path file = run / "measured/surfaces/surface_0016.vtp";
  const SurfaceFile surface(file);
  EXPECT_TRUE(contains(read_text(run / "measured/surfaces/surfaces.pvd"), "surface_0016.vtp"));
  EXPECT_EQ(surface.pressure, read_frame(file).pressure) << "a reader of VTP must understand it";
  const Table observables = read_table(run / "observables.csv");
  const char* names[] = {"x_min", "x_max", "y_min", "y_max"};
  for (int part = 0; part < 4; ++part)
    for (std::size_t d = 0; d < 2; ++d) {
      double sum = 0;
      for (std::size_t k = 0; k < surface.part.size(); ++k)
        if (int(surface.part[k]) == part) sum += surface.traction[3 * k + d] * surface.area[k];
      const std::string name = std::string("force on ") + names[part] + (d == 0 ? " x" : " y");
      EXPECT_NEAR(sum, column(forces, name).back(), 1e-5 * 9810 * 0.5) << name;
      EXPECT_NEAR(sum, column(observables, name).back(), 1e-5 * 9810 * 0.5) << name;
    }
}

}  // namespace
}  // namespace freshet::test
