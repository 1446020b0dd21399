// SPDX-License-Identifier: MIT
#include "freshet/plot.h"

#include <fmt/format.h>

#include "command.h"
#include "print.h"

namespace freshet::cli {
namespace {

struct PlotArguments {
  std::string run, output;
  std::vector<std::string> columns, against;
};

/// A column may be named with its unit, as the file does.
std::string without_unit(const std::string& column) {
  const auto unit = column.rfind(" [");
  return unit != std::string::npos && column.ends_with(']') ? column.substr(0, unit) : column;
}

void draw(const PlotArguments& a) {
  PlotOptions options;
  options.run = a.run;
  options.output = a.output;
  options.against.assign(a.against.begin(), a.against.end());
  for (const std::string& column : a.columns) options.columns.push_back(without_unit(column));
  for (const auto& file : plot(options)) print_out("wrote {}\n", printable(file.string()));
}

}  // namespace

void add_plot(Program& program) {
  const auto a = std::make_shared<PlotArguments>();
  const Command command = program.add("plot", "Draw a run's observables over its time");
  command.option("DIR", a->run, "the folder of a run").required();
  command
      .option("--columns", a->columns,
              "columns to draw, with commas between them, of any table over time: \"speed max\", "
              "\"GAUGE: distance\", \"BODY: y\" (default: those of observables.csv that matter)")
      .delimiter(',');
  command
      .option("--output", a->output,
              "FILE.svg, FILE.png, or a folder for both (default: DIR/plots)")
      .value("FILE");
  command.option("--against", a->against, "other runs to compare it with (at most 3)").value("DIR");
  command.footer(
      "Examples:\n  freshet plot runs/dam_break_2d\n"
      "  freshet plot runs/a --against runs/b --columns \"speed max,total energy\" "
      "--output speed.svg");
  command.action([a] {
    draw(*a);
    return done;
  });
}

}  // namespace freshet::cli
