// SPDX-License-Identifier: MIT
#include "freshet/plot.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "core/text.h"
#include "freshet/error.h"
#include "io/folder.h"
#include "render/chart.h"
#include "run/table.h"
#include "scene/keys/suggest.h"

namespace freshet {
namespace {

namespace fs = std::filesystem;

constexpr Series::Style styles[] = {Series::Style::solid, Series::Style::dashed,
                                    Series::Style::dotted, Series::Style::dash_dot};

[[noreturn]] void refuse(const std::string& place, const std::string& why,
                         std::vector<std::string> options = {}) {
  throw Error(Error::Kind::scene, place, why, std::move(options));
}

/// A run as it is drawn: its numbers, and the style of its lines.
struct Run {
  std::string name;
  Table table;
  Series::Style style;
  bool first;  ///< the legend is made of its lines
};

/// Kinetic and potential energy together, beside what the file holds.
void add_total_energy(Table& table) {
  const Column *kinetic = table.find("kinetic energy"), *potential = table.find("potential energy");
  if (!kinetic || !potential || kinetic->of_words() || potential->of_words()) return;
  Column total{"total energy", kinetic->unit, {}, {}};
  for (std::size_t row = 0; row < table.rows; ++row)
    total.numbers.push_back(kinetic->numbers[row] + potential->numbers[row]);
  table.columns.push_back(std::move(total));
}

Run read_run(const fs::path& folder, std::size_t place) {
  const fs::path file = folder / "observables.csv";
  std::error_code ec;
  if (!fs::is_directory(folder, ec))
    refuse(folder.string(), "no such folder; give the folder of a run, as in runs/article");
  if (!fs::is_regular_file(file, ec))
    refuse(folder.string(),
           "no observables.csv in this folder; give the folder of a run whose first frame is "
           "written");
  Run run{folder.lexically_normal().string(), read_table(file), styles[place], place == 0};
  const Column* time = run.table.find("time");
  if (!time || time->of_words())
    refuse(file.string() + ":1",
           "no column \"time [s]\", so this was not written by a run; give the folder of a run");
  if (run.table.rows == 0)
    refuse(file.string(), "no row yet; wait until the run has written its first frame");
  add_total_energy(run.table);
  return run;
}

/// "kg/m^2" as it is printed.
std::string printed(std::string unit) {
  for (const auto& [plain, raised] : {std::pair("^2", "²"), std::pair("^3", "³")})
    if (const auto at = unit.find(plain); at != std::string::npos) unit.replace(at, 2, raised);
  return unit.empty() ? "" : "[" + unit + "]";
}

/// A run's column as a line of a panel; nothing if the run has no such numbers.
void add_line(Panel& panel, const Run& run, const std::string& column, const std::string& name,
              int color) {
  const Column* y = run.table.find(column);
  if (!y || y->of_words()) return;
  panel.series.push_back(
      {run.first ? name : "", run.table.find("time")->numbers, y->numbers, run.style, color});
}

/// What a panel shows: columns, and what the legend calls them.
struct Topic {
  std::string label;
  std::vector<std::pair<std::string, std::string>> columns;
};

Panel panel_of(const Topic& topic, const std::vector<Run>& runs) {
  Panel panel{"", "time [s]", topic.label, {}};
  for (const Run& run : runs)
    for (std::size_t k = 0; k < topic.columns.size(); ++k)
      add_line(panel, run, topic.columns[k].first, topic.columns[k].second, int(k));
  return panel;
}

/// The parts of a line that end where `words` say `word`.
Series parts_of(const Column& time, const Column& y, const Column& words, const std::string& word) {
  Series s;
  std::size_t next = 0;  // after the last point
  for (std::size_t row = 0; row < words.words.size(); ++row) {
    if (words.words[row] != word) continue;
    if (next != row || row == 0) {
      s.x.push_back(time.numbers[row]);
      s.y.push_back(NAN);
      if (row > 0) {
        s.x.push_back(time.numbers[row - 1]);
        s.y.push_back(y.numbers[row - 1]);
      }
    }
    s.x.push_back(time.numbers[row]);
    s.y.push_back(y.numbers[row]);
    next = row + 1;
  }
  return s;
}

/// The time step, in the colour of what ruled it, and the least of its bounds.
Panel time_step_panel(const std::vector<Run>& runs) {
  struct Rule {
    const char *word, *name;
    int color;
  };
  static constexpr Rule rules[] = {{"fixed", "step, fixed", 0},
                                   {"sound", "step, by sound", 0},
                                   {"step_max", "step_max", 1},
                                   {"force", "step, by force", 2},
                                   {"viscosity", "step, by viscosity", 3},
                                   {"flow", "step, by flow", 4},
                                   {"retry", "step, halved", 5}};
  Panel panel{"", "time [s]", "time step [s]", {}};
  for (const Run& run : runs) {
    add_line(panel, run, "least bound", "least bound", 7);
    const Column *step = run.table.find("time step"), *ruled = run.table.find("ruled by");
    if (!step || step->of_words() || !ruled || !ruled->of_words()) continue;
    for (const Rule& rule : rules) {
      Series part = parts_of(*run.table.find("time"), *step, *ruled, rule.word);
      if (part.x.empty()) continue;
      part.name = run.first ? rule.name : "";
      part.style = run.style;
      part.color = rule.color;
      panel.series.push_back(std::move(part));
    }
  }
  return panel;
}

/// The walls that ever feel a force along an axis.
Topic forces_along(const std::string& axis, const Table& table) {
  const std::string front = "force on ", back = " " + axis;
  Topic topic{"wall force " + axis, {}};
  for (const Column& c : table.columns) {
    if (!c.name.starts_with(front) || !c.name.ends_with(back)) continue;
    if (std::all_of(c.numbers.begin(), c.numbers.end(), [](double f) { return f == 0; })) continue;
    const std::size_t length = c.name.size() - front.size() - back.size();
    if (topic.columns.empty()) topic.label += " " + printed(c.unit);
    topic.columns.emplace_back(c.name, c.name.substr(front.size(), length));
  }
  return topic;
}

/// The rates through inlets, outlets, counters and open sides.
Topic flows_in(const Table& table) {
  const std::string front = "flow through ";
  Topic topic{"flow", {}};
  for (const Column& c : table.columns) {
    if (!c.name.starts_with(front)) continue;
    if (topic.columns.empty()) topic.label += " " + printed(c.unit);
    topic.columns.emplace_back(c.name, c.name.substr(front.size()));
  }
  return topic;
}

std::vector<Panel> usual_panels(const std::vector<Run>& runs) {
  std::vector<Panel> panels;
  panels.push_back(panel_of({"energy [J]",
                             {{"kinetic energy", "kinetic"},
                              {"potential energy", "potential"},
                              {"total energy", "total"}}},
                            runs));
  panels.push_back(panel_of(
      {"momentum [kg m/s]", {{"momentum x", "x"}, {"momentum y", "y"}, {"momentum z", "z"}}},
      runs));
  // the greatest is so much more than the mean that they would not share a panel well
  panels.push_back(panel_of({"density error [%]", {{"density error mean", "mean"}}}, runs));
  panels.push_back(panel_of({"density error [%]", {{"density error max", "greatest"}}}, runs));
  panels.push_back(
      panel_of({"speed [m/s]", {{"speed mean", "mean"}, {"speed max", "fastest"}}}, runs));
  panels.push_back(time_step_panel(runs));
  panels.push_back(panel_of(
      {"iterations", {{"density iterations", "density"}, {"divergence iterations", "divergence"}}},
      runs));
  panels.push_back(
      panel_of({"solve error [%]",
                {{"density solve error", "density"}, {"divergence solve error", "divergence"}}},
               runs));
  panels.push_back(panel_of(flows_in(runs[0].table), runs));
  panels.push_back(panel_of({"particles", {{"particles", "particles"}}}, runs));
  for (const char* axis : axis_letters)
    panels.push_back(panel_of(forces_along(axis, runs[0].table), runs));
  std::erase_if(panels, [](const Panel& p) { return p.series.empty(); });
  return panels;
}

/// The columns that can be drawn over time.
std::set<std::string, std::less<>> drawable(const Table& table) {
  std::set<std::string, std::less<>> names;
  for (const Column& c : table.columns)
    if (!c.of_words() && c.name != "time") names.insert(c.name);
  return names;
}

[[noreturn]] void refuse_column(const std::string& typed, const Run& run) {
  const auto names = drawable(run.table);
  const std::string near = nearest(typed, names);
  refuse("option columns",
         fmt::format("no column \"{}\" of numbers in {}/observables.csv; {}there are "
                     "{}",
                     typed, run.name, near.empty() ? "" : fmt::format("did you mean {}? ", near),
                     fmt::join(names, ", ")));
}

/// The columns asked for, those of one unit in one panel.
std::vector<Panel> panels_of(const std::vector<std::string>& columns,
                             const std::vector<Run>& runs) {
  std::vector<std::pair<std::string, Topic>> topics;  // by unit
  for (const std::string& column : columns) {
    for (const Run& run : runs)
      if (!drawable(run.table).contains(column)) refuse_column(column, run);
    const std::string unit = runs[0].table.find(column)->unit;
    auto topic =
        std::find_if(topics.begin(), topics.end(), [&](const auto& t) { return t.first == unit; });
    if (topic == topics.end()) topic = topics.insert(topic, {unit, {printed(unit), {}}});
    topic->second.columns.emplace_back(column, column);
  }
  std::vector<Panel> panels;
  for (const auto& [unit, topic] : topics) panels.push_back(panel_of(topic, runs));
  return panels;
}

/// Where the picture goes: one file of the kind that is named, or both kinds in a folder.
std::vector<fs::path> files_of(const PlotOptions& o) {
  const fs::path output = o.output.empty() ? o.run / "plots" : o.output;
  const std::string kind = output.extension().string();
  std::error_code ec;
  if (fs::is_directory(output, ec) || kind.empty())
    return {output / "observables.svg", output / "observables.png"};
  if (kind == ".svg" || kind == ".png") return {output};
  refuse(output.string(), "a plot is FILE.svg or FILE.png, or both in a folder; name one of these");
}

/// Writes below the folder of the run, or where the user wants it.
void write_plot(const PlotOptions& options, const fs::path& file, const std::string& bytes) {
  if (options.output.empty()) {
    const Folder run(options.run);
    const std::string name = "plots/" + file.filename().string();
    run.make_folder_of(name);
    return run.write(name, bytes);
  }
  if (file.has_parent_path()) made_folder(file.parent_path());
  write_file(file, bytes);
}

}  // namespace

std::vector<fs::path> plot(const PlotOptions& options) {
  if (options.against.size() + 1 > std::size(styles))
    refuse("option against",
           fmt::format("{} runs, and more than {} cannot be told apart; draw some of "
                       "them",
                       options.against.size(), std::size(styles) - 1));
  const std::vector<fs::path> files = files_of(options);
  std::vector<Run> runs{read_run(options.run, 0)};
  for (const fs::path& folder : options.against) runs.push_back(read_run(folder, runs.size()));
  Chart chart;
  if (runs.size() == 1) chart.title = runs[0].name;
  else
    for (const Run& run : runs) chart.styles.emplace_back(run.style, run.name);
  chart.panels = options.columns.empty() ? usual_panels(runs) : panels_of(options.columns, runs);
  if (chart.panels.empty())
    refuse((options.run / "observables.csv").string(),
           "none of the columns that every run has; name those to draw with `columns`",
           {"columns"});
  for (const fs::path& file : files)
    write_plot(options, file, file.extension() == ".svg" ? chart_svg(chart) : chart_png(chart));
  return files;
}

}  // namespace freshet
