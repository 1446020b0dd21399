// SPDX-License-Identifier: MIT
/// `freshet plot` draws the observables of a run.
#include <gtest/gtest.h>

#include <pugixml.hpp>

#include "cli/files.h"
#include "cli/process.h"
#include "render/png.h"

namespace freshet::test {
namespace {

/// Writes an observables.csv of two rows and the lines `more`; returns the folder's name.
std::string run_in(const fs::path& folder, const std::string& more = "") {
  write_text(folder / "observables.csv",
             "step,time [s],time step [s],ruled by,least bound [s],kinetic energy [J],"
             "potential energy [J],speed mean [m/s],speed max [m/s],force on floor y [N/m]\n"
             "1,0.5,0.5,sound,0.5,1,20,2,3,-7\n2,1,0.5,step_max,0.6,2,19,2,4,-8\n" +
                 more);
  return folder.string();
}

/// Expects this exit code, one line on stderr and nothing on stdout; returns the line.
std::string error_of(const std::vector<std::string>& arguments, int code) {
  const auto r = freshet(arguments);
  EXPECT_EQ(r.code, code) << r.err;
  EXPECT_EQ(r.out, "");
  EXPECT_EQ(lines_of(r.err).size(), 1u) << r.err;
  return r.err;
}

/// The number of panels in an SVG. The frame of a panel is a closed rectangle without a fill.
std::size_t panels_in(const fs::path& svg) {
  pugi::xml_document document;
  EXPECT_TRUE(document.load_file(svg.c_str()));
  std::size_t count = 0;
  for (const auto& found : document.select_nodes("//*[local-name()='path']")) {
    const std::string style = found.node().attribute("style").value(),
                      path = found.node().attribute("d").value();
    count += contains(style, "fill:none") && contains(path, "Z");
  }
  return count;
}

constexpr const char *blue = "rgb(0%,44.7%,69.8%)", *vermilion = "rgb(83.5%,36.9%,0%)";

/// The lines of a colour in an SVG, each as the commands of its path: M moves, L draws.
std::vector<std::string> lines_in(const fs::path& svg, const std::string& color) {
  pugi::xml_document document;
  EXPECT_TRUE(document.load_file(svg.c_str()));
  std::vector<std::string> all;
  for (const auto& found : document.select_nodes("//*[local-name()='path']")) {
    if (!contains(found.node().attribute("style").value(), "stroke:" + color)) continue;
    std::string path = found.node().attribute("d").value();
    std::erase_if(path, [](char c) { return c != 'M' && c != 'L'; });
    all.push_back(path);
  }
  return all;
}

TEST(Plot, DrawsTheSamePictureTwiceAndKeepsOtherFiles) {
  const TemporaryFolder folder;
  const auto run = freshet(short_run(folder / "run", {"--set", "checks.height_mean_max=3"}));
  ASSERT_EQ(run.code, 0) << run.err;
  const std::string manifest = read_text(folder / "run/manifest.json");
  write_text(folder / "run/plots/mine.txt", "mine");
  std::string first;
  for (int k = 0; k < 2; ++k) {
    const auto r = freshet({"plot", (folder / "run").string()});
    EXPECT_EQ(r.code, 0) << r.err;
    EXPECT_EQ(r.err, "");
    EXPECT_EQ(r.out, "wrote " + (folder / "run/plots/observables.svg").string() + "\nwrote " +
                         (folder / "run/plots/observables.png").string() + "\n");
    const std::string svg = read_text(folder / "run/plots/observables.svg");
    if (k == 0) first = svg;
    EXPECT_TRUE(first == svg);
  }
  // energies, momentum, two density errors, speed, time step, forces along x and along y
  EXPECT_EQ(panels_in(folder / "run/plots/observables.svg"), 8u);
  const Image png = decode_png(read_text(folder / "run/plots/observables.png"));
  EXPECT_EQ(png.width, 1440);
  EXPECT_GT(png.height, 1440);
  EXPECT_GT(std::count(png.pixels.begin(), png.pixels.end(), Color{0, 114, 178}), 1000);
  EXPECT_EQ(read_text(folder / "run/manifest.json"), manifest);
  EXPECT_EQ(read_text(folder / "run/plots/mine.txt"), "mine");
  const auto again = freshet(short_run(folder / "run", {"--overwrite", "--quiet"}));
  EXPECT_EQ(again.err.find("plots"), std::string::npos) << again.err;
  EXPECT_TRUE(read_text(folder / "run/plots/observables.svg") == first);
}

TEST(Plot, DrawsTheNamedColumns) {
  const TemporaryFolder folder;
  const std::string run = run_in(folder / "run"), svg = (folder / "below/a.svg").string();
  const auto drawn = [&](const std::string& columns) {
    const auto r = freshet({"plot", run, "--columns", columns, "--output", svg});
    EXPECT_EQ(r.code, 0) << r.err;
    EXPECT_EQ(r.out, "wrote " + svg + "\n");
    return panels_in(svg);
  };
  EXPECT_EQ(drawn("speed mean"), 1u);
  EXPECT_EQ(drawn("speed mean,speed max"), 1u);  // both have one unit
  EXPECT_EQ(drawn("speed mean,total energy,speed max [m/s],step"), 3u);
  EXPECT_EQ(files_below(folder.path()),
            (std::set<std::string>{"below/a.svg", "run/observables.csv"}));
}

TEST(Plot, FindsColumnsInEveryTable) {
  const TemporaryFolder folder;
  const std::string run = run_in(folder / "run"), svg = (folder / "a.svg").string();
  write_text(folder / "run/probes/gauge.csv", "time [s],distance [m]\n0.5,1\n1,2\n");
  write_text(folder / "run/probes/other.csv", "time [s],distance [m]\n0.5,3\n1,4\n");
  write_text(folder / "run/probes/line.csv", "time [s],x [m],pressure [Pa]\n1,0,5\n1,1,6\n");
  write_text(folder / "run/bodies.csv",
             "step,time [s],body,y [m]\n1,0.5,box,1\n1,0.5,lid,2\n2,1,box,3\n2,1,lid,4\n");
  const auto lines = [&](const std::string& columns) {
    const auto r = freshet({"plot", run, "--columns", columns, "--output", svg});
    EXPECT_EQ(r.code, 0) << r.err;
    std::size_t count = 0;  // each curve has a second line in the legend
    for (const std::string& color : {std::string(blue), std::string(vermilion)})
      count += lines_in(svg, color).size() / 2;
    return count;
  };
  EXPECT_EQ(lines("distance"), 2u);  // of both probes
  EXPECT_EQ(lines("gauge: distance"), 1u);
  EXPECT_EQ(lines("box: y"), 1u);
  EXPECT_EQ(lines("gauge: distance,box: y [m]"), 2u);
  EXPECT_EQ(panels_in(svg), 1u);  // both have one unit
  EXPECT_EQ(lines("y,speed max"), 3u);
  EXPECT_EQ(panels_in(svg), 2u);
  const std::string error = error_of({"plot", run, "--columns", "gauge: distence"}, 2);
  EXPECT_TRUE(contains(error, "did you mean gauge: distance?")) << error;
  EXPECT_FALSE(contains(error, "line: pressure")) << error;  // a line has no column over time
  EXPECT_FALSE(contains(error, "box: y")) << error;          // a column of the body
}

TEST(Plot, DrawsRunsOfOlderVersionsIn2DWithTheUnitsOfNewOnes) {
  const TemporaryFolder folder;
  const auto write = [&](const std::string& name, const std::string& density,
                         const std::string& energy, const std::string& pressure) {
    write_text(folder / name / "observables.csv", "step,time [s],density mean [" + density +
                                                      "],kinetic energy [" + energy +
                                                      "]\n0,0,1,2\n1,1,2,3\n");
    write_text(folder / name / "probes/p.csv", "time [s],pressure [" + pressure + "]\n0,1\n1,2\n");
    return (folder / name).string();
  };
  const std::string older = write("older", "kg/m^2", "J", "N/m"),
                    present = write("present", "kg/m^3", "J/m", "Pa"),
                    solid = write("solid", "kg/m^3", "J", "Pa"), svg = (folder / "a.svg").string();
  const auto panels = [&](const std::string& run, const std::string& against) {
    const auto r = freshet({"plot", run, "--against", against, "--columns",
                            "density mean,kinetic energy,p: pressure", "--output", svg});
    EXPECT_EQ(r.code, 0) << r.err;
    return panels_in(svg);
  };
  EXPECT_EQ(panels(older, present), 3u);
  EXPECT_EQ(panels(solid, present), 4u);  // J and J/m
}

TEST(Plot, DrawsIterationsAndHalvedSteps) {
  const TemporaryFolder folder;
  write_text(folder / "run/observables.csv",
             "step,time [s],time step [s],ruled by,least bound [s],divergence iterations,"
             "divergence solve error [%],density iterations,density solve error [%]\n"
             "0,0,0,,0.5,0,0,0,0\n1,0.5,0.5,flow,0.5,2,0.05,3,0.009\n"
             "2,0.75,0.25,retry,0.5,2,0.04,9,0.008\n3,1.25,0.5,flow,0.5,3,0.05,4,0.007\n");
  const std::string svg = (folder / "a.svg").string();
  const auto r = freshet({"plot", (folder / "run").string(), "--output", svg});
  EXPECT_EQ(r.code, 0) << r.err;
  EXPECT_EQ(panels_in(svg), 3u);  // time step, iterations, error of the solves
  // each curve has a second line in the legend
  EXPECT_EQ(lines_in(svg, vermilion).size(), 4u);  // divergence is in two panels
  const std::string orange = "rgb(90.2%,62.4%,0%)", sky = "rgb(33.7%,70.6%,91.4%)";
  EXPECT_EQ(lines_in(svg, orange).size(), 2u);  // steps that the flow limits
  EXPECT_EQ(lines_in(svg, sky).size(), 2u);     // the halved step
}

TEST(Plot, WritesToTheGivenFileOrFolder) {
  const TemporaryFolder folder;
  const std::string run = run_in(folder / "run");
  fs::create_directories(folder / "v1.0");
  for (const char* output : {"a.svg", "b.png", "c", "v1.0"})
    EXPECT_EQ(freshet({"plot", run, "--output", (folder / output).string()}).code, 0) << output;
  EXPECT_EQ(files_below(folder.path()),
            (std::set<std::string>{"a.svg", "b.png", "c/observables.svg", "c/observables.png",
                                   "v1.0/observables.svg", "v1.0/observables.png",
                                   "run/observables.csv"}));
  const std::string pdf = (folder / "a.pdf").string();
  EXPECT_EQ(
      error_of({"plot", run, "--output", pdf}, 2),
      pdf + ": error: a plot is FILE.svg or FILE.png, or both in a folder; name one of these\n");
  EXPECT_TRUE(contains(error_of({"plot", run, "--output", "/proc/no/such"}, 1),
                       "error: cannot make this folder: "));
}

TEST(Plot, ComparesARunWithUpToThreeOthers) {
  const TemporaryFolder folder;
  const std::string a = run_in(folder / "a"), b = run_in(folder / "b"),
                    svg = (folder / "both.svg").string();
  freshet({"plot", a, "--columns", "speed max", "--output", svg});
  EXPECT_EQ(lines_in(svg, blue).size(), 2u);  // curve and legend
  const auto r = freshet({"plot", a, "--against", b, "--columns", "speed max", "--output", svg});
  EXPECT_EQ(r.code, 0) << r.err;
  EXPECT_EQ(lines_in(svg, blue).size(), 3u);
  EXPECT_TRUE(contains(read_text(svg), "stroke-dasharray:5,3"));
  EXPECT_EQ(freshet({"plot", a, "--against", b, a, b, "--output", svg}).code, 0);
  EXPECT_EQ(error_of({"plot", a, "--against", b, a, b, a}, 2),
            "--against: error: 4 runs, and more than 3 cannot be told apart; draw some of them\n");
}

// Steps limited by sound are blue, steps of step_max vermilion.
TEST(Plot, ColorsTheTimeStepByItsLimit) {
  const TemporaryFolder folder;
  write_text(folder / "observables.csv",
             "step,time [s],time step [s],ruled by\n"
             "1,0.5,0.5,sound\n2,1,0.7,step_max\n3,1.5,0.4,step_max\n4,2,0.6,sound\n");
  EXPECT_EQ(freshet({"plot", folder.path().string()}).code, 0);
  using Lines = std::vector<std::string>;  // the last is in the legend
  EXPECT_EQ(lines_in(folder / "plots/observables.svg", blue),
            (Lines{"MLML", "ML"}));  // the first step is a dot
  EXPECT_EQ(lines_in(folder / "plots/observables.svg", vermilion), (Lines{"MLL", "ML"}));
}

TEST(Plot, ListsTheColumnsIfOneIsUnknown) {
  const TemporaryFolder folder;
  const std::string run = run_in(folder / "run");
  const std::string all =
      "there are force on floor y, kinetic energy, least bound, potential energy, speed max, speed "
      "mean, step, time step, total energy\n";
  EXPECT_EQ(error_of({"plot", run, "--columns", "speed maks"}, 2),
            "--columns: error: no column \"speed maks\" of numbers over time in the tables of " +
                run + "; did you mean speed max? " + all);
  EXPECT_EQ(error_of({"plot", run, "--columns", "ruled by"}, 2),
            "--columns: error: no column \"ruled by\" of numbers over time in the tables of " +
                run + "; " + all);
  EXPECT_FALSE(fs::exists(folder / "run/plots"));
}

TEST(Plot, IgnoresAnIncompleteLastRow) {
  const TemporaryFolder folder;
  const std::string run = run_in(folder / "run", "3,1.5,0.5,sou");
  EXPECT_EQ(freshet({"plot", run}).code, 0);
  const std::string torn = read_text(folder / "run/plots/observables.svg");
  run_in(folder / "run");
  EXPECT_EQ(freshet({"plot", run}).code, 0);
  EXPECT_TRUE(torn == read_text(folder / "run/plots/observables.svg"));
}

TEST(Plot, RejectsAFolderWithoutARun) {
  const TemporaryFolder folder;
  const std::string here = folder.path().string();
  EXPECT_EQ(
      error_of({"plot", here + "/none"}, 2),
      here + "/none: error: no such folder; name the folder of a run, such as runs/article\n");
  EXPECT_EQ(
      error_of({"plot", here}, 2),
      here +
          ": error: no observables.csv in this folder; name the folder of a run that has written "
          "its first frame\n");
  const std::string file = here + "/observables.csv";
  write_text(file, "step,time [s]\n");
  EXPECT_EQ(error_of({"plot", here}, 2),
            file + ": error: no row yet; wait until the run has written its first frame\n");
  write_text(file, "a,b\n1,2\n");
  EXPECT_EQ(error_of({"plot", here}, 2),
            file +
                ":1: error: no column \"time [s]\", so no run wrote this table; name the "
                "folder of a run\n");
  write_text(file, "time [s],a\n1,2\n");
  EXPECT_EQ(error_of({"plot", here}, 2),
            file +
                ": error: none of the columns that every run has; name those to draw with "
                "--columns\n");
  EXPECT_EQ(freshet({"plot", here, "--columns", "a"}).code, 0);
  write_text(file, "step,time [s]\n1\n2,3\n");
  EXPECT_TRUE(contains(error_of({"plot", here}, 2), file + ":2: error: 1 value instead of 2"));
  EXPECT_TRUE(contains(error_of({"plot"}, 2), "DIR"));
  EXPECT_TRUE(contains(error_of({"plot", here, "--frobnicate"}, 2), "--frobnicate"));
}

TEST(Plot, LeavesNoPartialPictureOnAFullDisk) {
  const TemporaryFolder folder;
  const std::string run = run_in(folder / "run");
  const auto r = freshet({"plot", run}, {.file_limit = 1000});
  EXPECT_EQ(r.code, 1) << r.err;
  EXPECT_TRUE(contains(r.err, "observables.svg: error: cannot write: ")) << r.err;
  EXPECT_EQ(files_below(folder.path()), (std::set<std::string>{"run/observables.csv"}));
}

TEST(Plot, DrawsRunsWhoseNamesAreNotUtf8) {
  const TemporaryFolder folder;
  const auto r = freshet({"plot", run_in(folder / "\xFF\nrun")});
  EXPECT_EQ(r.code, 0) << r.err;
  EXPECT_EQ(lines_of(r.out).size(), 2u) << r.out;
  EXPECT_TRUE(contains(r.out, "\xFF\\nrun/plots/observables.svg\n")) << r.out;
  EXPECT_GT(panels_in(folder / "\xFF\nrun/plots/observables.svg"), 0u);
}

TEST(Plot, DrawsMeasuredTables) {
  const TemporaryFolder folder;
  const std::string run = run_in(folder.path()), svg = (folder / "gauge.svg").string();
  write_text(folder / "measured.csv",
             "frame,time [s],gauge: pressure [Pa]\nframe_0000.vtp,0,5\nframe_0001.vtp,1,7\n");
  for (const char* name : {"gauge: pressure", "measured: gauge: pressure"}) {
    const auto r = freshet({"plot", run, "--columns", name, "--output", svg});
    EXPECT_EQ(r.code, 0) << r.err;
    EXPECT_EQ(panels_in(svg), 1u);
  }
  EXPECT_TRUE(contains(error_of({"plot", run, "--columns", "gauge: level"}, 2), "gauge: pressure"));
}

}  // namespace
}  // namespace freshet::test
