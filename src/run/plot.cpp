// SPDX-License-Identifier: MIT
#include "freshet/plot.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <sstream>

#include "core/text.h"
#include "freshet/error.h"
#include "freshet/suggest.h"
#include "io/folder.h"
#include "render/axis.h"
#include "render/chart.h"
#include "run/plot_tables.h"

namespace freshet {
namespace {

namespace fs = std::filesystem;

constexpr Series::Style styles[] = {Series::Style::solid, Series::Style::dashed,
                                    Series::Style::dotted, Series::Style::dash_dot};

[[noreturn]] void refuse(const std::string& place, const std::string& why,
                         std::vector<std::string> options = {}) {
  throw Error(Error::Kind::scene, place, why, std::move(options));
}

/// A run and the style of its lines. The legend is made of the lines of the first run.
struct Run {
  std::string name;
  RunTables tables;
  Series::Style style;
  bool first;
};

Run read_run(const fs::path& folder, std::size_t place) {
  return {folder.lexically_normal().string(), RunTables(folder), styles[place], place == 0};
}

/// Adds a run's column as a line of a panel, if the run has it.
void add_line(Panel& panel, const Run& run, const std::string& column, const std::string& name,
              int color) {
  const Column* y = run.tables.observables().find(column);
  if (!y || y->of_words()) return;
  panel.series.push_back({run.first ? name : "", run.tables.observables().find("time")->numbers,
                          y->numbers, run.style, color});
}

/// The columns of a panel, and their names in the legend.
struct Topic {
  std::string quantity;
  std::vector<std::pair<std::string, std::string>> columns;
};

/// The unit of the first column that a run has.
std::string unit_of(const Topic& topic, const std::vector<Run>& runs) {
  for (const Run& run : runs)
    for (const auto& [column, name] : topic.columns)
      if (const Column* c = run.tables.observables().find(column)) return c->unit;
  return "";
}

Panel panel_of(const Topic& topic, const std::vector<Run>& runs) {
  Panel panel{"", "time [s]", axis_title(topic.quantity, unit_of(topic, runs)), {}};
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

/// The time step, in the colour of its limit, and the minimum of the bounds.
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
    const Column *step = run.tables.observables().find("time step"),
                 *ruled = run.tables.observables().find("ruled by");
    if (!step || step->of_words() || !ruled || !ruled->of_words()) continue;
    for (const Rule& rule : rules) {
      Series part = parts_of(*run.tables.observables().find("time"), *step, *ruled, rule.word);
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
    topic.columns.emplace_back(c.name, c.name.substr(front.size()));
  }
  return topic;
}

std::vector<Panel> usual_panels(const std::vector<Run>& runs) {
  std::vector<Panel> panels;
  panels.push_back(panel_of({"energy",
                             {{"kinetic energy", "kinetic"},
                              {"potential energy", "potential"},
                              {"total energy", "total"}}},
                            runs));
  panels.push_back(panel_of(
      {"momentum", {{"momentum x", "x"}, {"momentum y", "y"}, {"momentum z", "z"}}}, runs));
  // the greatest is so much more than the mean that they would not share a panel well
  panels.push_back(panel_of({"density error", {{"density error mean", "mean"}}}, runs));
  panels.push_back(panel_of({"density error", {{"density error max", "greatest"}}}, runs));
  panels.push_back(panel_of({"speed", {{"speed mean", "mean"}, {"speed max", "fastest"}}}, runs));
  panels.push_back(time_step_panel(runs));
  panels.push_back(panel_of(
      {"iterations", {{"density iterations", "density"}, {"divergence iterations", "divergence"}}},
      runs));
  panels.push_back(
      panel_of({"solve error",
                {{"density solve error", "density"}, {"divergence solve error", "divergence"}}},
               runs));
  panels.push_back(panel_of(flows_in(runs[0].tables.observables()), runs));
  panels.push_back(panel_of({"particles", {{"particles", "particles"}}}, runs));
  for (const char* axis : axis_letters)
    panels.push_back(panel_of(forces_along(axis, runs[0].tables.observables()), runs));
  std::erase_if(panels, [](const Panel& p) { return p.series.empty(); });
  return panels;
}

/// The columns that the user may have meant: those of the probe or body that is named, or all.
std::set<std::string, std::less<>> columns_to_offer(const std::string& typed, const Run& run) {
  const auto all = run.tables.names();
  const std::size_t colon = typed.find(": ");
  if (colon == std::string::npos) return all;
  std::set<std::string, std::less<>> own;
  for (const std::string& name : all)
    if (name.starts_with(typed.substr(0, colon + 2))) own.insert(name);
  return own.empty() ? all : own;
}

[[noreturn]] void refuse_column(const std::string& typed, const Run& run) {
  const auto names = columns_to_offer(typed, run);
  const std::string near = nearest(typed, names);
  refuse("option columns",
         fmt::format("no column \"{}\" of numbers over time in the tables of {}; {}there are {}",
                     typed, run.name, near.empty() ? "" : fmt::format("did you mean {}? ", near),
                     fmt::join(names, ", ")));
}

/// The quantity that columns of one unit have in common: the name of a single column, or the words
/// with which all names begin or end, without their probes and bodies.
std::string common_quantity(const std::vector<std::string>& names) {
  if (names.size() == 1) return names[0];
  std::vector<std::vector<std::string>> words;
  for (const std::string& name : names) {
    std::istringstream text(
        name.substr(name.rfind(": ") == std::string::npos ? 0 : name.rfind(": ") + 2));
    words.emplace_back(std::istream_iterator<std::string>(text),
                       std::istream_iterator<std::string>());
  }
  const auto begin = [&] {
    std::string common;
    for (std::size_t k = 0; k < words[0].size(); ++k) {
      if (std::any_of(words.begin(), words.end(),
                      [&](const auto& w) { return k >= w.size() || w[k] != words[0][k]; }))
        break;
      common += (k == 0 ? "" : " ") + words[0][k];
    }
    return common;
  };
  if (const std::string common = begin(); !common.empty()) return common;
  for (auto& w : words) w = {w.back()};
  return begin();
}

/// The named columns, those of one unit in one panel.
std::vector<Panel> panels_of(const std::vector<std::string>& columns, std::vector<Run>& runs) {
  struct Group {
    std::string unit;
    Panel panel;
    std::vector<std::string> names;
  };
  std::vector<Group> groups;
  const auto group_of = [&](const std::string& unit) -> Group& {
    for (Group& group : groups)
      if (group.unit == unit) return group;
    return groups.emplace_back(Group{unit, {"", "time [s]", "", {}}, {}});
  };
  for (Run& run : runs) run.tables.read_all();
  for (const std::string& column : columns)
    for (const Run& run : runs) {
      const auto found = run.tables.find(column);
      if (found.empty()) refuse_column(column, run);
      for (const PlotColumn& c : found) {
        Group& group = group_of(c.values->unit);
        const auto at = std::find(group.names.begin(), group.names.end(), c.name);
        const bool is_new = at == group.names.end();
        const int color = int(at - group.names.begin());
        if (is_new) group.names.push_back(c.name);
        group.panel.series.push_back({run.first || is_new ? c.name : "", c.time->numbers,
                                      c.values->numbers, run.style, color});
      }
    }
  std::vector<Panel> panels;
  for (Group& group : groups) {
    group.panel.y_label = axis_title(common_quantity(group.names), group.unit);
    panels.push_back(std::move(group.panel));
  }
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
