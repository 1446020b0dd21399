// SPDX-License-Identifier: MIT
/// The manual page, from the help texts.
#include <fmt/format.h>

#include "command.h"
#include "freshet/version.h"
#include "print.h"

namespace freshet::cli {
namespace {

/// Text of a page: troff reads backslashes anywhere, and dots and quotes at the start of a line.
std::string escaped(const std::string& text) {
  std::string out;
  bool line_start = true;
  for (const char c : text) {
    if (line_start && (c == '.' || c == '\'')) out += "\\&";
    if (c == '\\') out += "\\e";
    else if (c == '-') out += "\\-";
    else out += c;
    line_start = c == '\n';
  }
  return out;
}

std::string item(const Program::OptionHelp& option) {
  const bool positional = !option.name.starts_with('-');
  const std::string value =
      positional || option.value.empty() ? "" : fmt::format(" \\fI{}\\fR", escaped(option.value));
  return fmt::format(".TP\n\\f{}{}\\fR{}\n{}\n", positional ? 'I' : 'B', escaped(option.name),
                     value, escaped(option.description));
}

std::string section(const Program::CommandHelp& command) {
  std::string usage = command.name + " [OPTIONS]", items;
  for (const auto& argument : command.positionals) {
    usage += " " + argument.name + (argument.repeatable ? "..." : "");
    items += item(argument);
  }
  for (const auto& option : command.options) items += item(option);
  return fmt::format(".SS freshet {}\n{}.\n{}.PP\n.nf\n{}\n.fi\n", escaped(usage),
                     escaped(command.description), items, escaped(command.footer));
}

std::string page(const Program& program) {
  std::string commands;
  for (const auto& command : program.help()) commands += section(command);
  return fmt::format(R"(.TH FRESHET 1 "" "freshet {}" "User Commands"
.SH NAME
freshet \- simulate fluids by smoothed particle hydrodynamics
.SH SYNOPSIS
\fBfreshet\fR \fICOMMAND\fR [\fIOPTIONS\fR]
.SH DESCRIPTION
A scene is a TOML file.
\fBfreshet scenes\fR lists the bundled scenes, \fBfreshet new\fR copies one, \fBfreshet run\fR runs
one into a folder of pictures and tables, and \fBfreshet schema \-\-markdown\fR prints all keys.
.SH COMMANDS
{}.SH EXIT STATUS
.TP
0
done
.TP
1
the run failed, or a check of the scene failed
.TP
2
wrong usage, or an error in the scene
.TP
130
interrupted
)",
                     FRESHET_VERSION, commands);
}

}  // namespace

void add_manual(Program& program) {
  const Command command = program.add("manual", "Print the manual page");
  command.footer("Example:\n  freshet manual | man -l -");
  command.action([&program] {
    put(page(program));
    return done;
  });
}

}  // namespace freshet::cli
