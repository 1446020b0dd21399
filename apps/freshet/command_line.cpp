// SPDX-License-Identifier: MIT
#include "command_line.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cmath>
#include <sstream>

#include "freshet/error.h"
#include "print.h"

namespace freshet::cli {
namespace {

/// Accepts numbers for which `allowed` holds. CLI::Range and CLI::PositiveNumber accept NaN.
CLI::Validator numbers(const std::function<bool(double)>& allowed, const std::string& words) {
  return CLI::Validator(
      [=](const std::string& text) {
        double value = 0;
        const bool good = CLI::detail::lexical_cast(text, value) && allowed(value);
        return good ? std::string()
                    : fmt::format("\"{}\" is not allowed; it must be a number {}", text, words);
      },
      "");
}

}  // namespace

Option Option::required() const { return Option(option_->required()); }
Option Option::one_of(const std::vector<std::string>& values) const {
  return Option(option_->check(CLI::IsMember(values)));
}
Option Option::range(int min, int max) const {
  return Option(option_->check(CLI::Range(min, max)));
}
Option Option::at_least(int min) const {
  return Option(
      option_->check(numbers([=](double x) { return x >= min; }, fmt::format("from {} on", min))));
}
Option Option::range(double min, double max) const {
  return Option(option_->check(numbers([=](double x) { return x >= min && x <= max; },
                                       fmt::format("from {:g} to {:g}", min, max))));
}
Option Option::positive() const {
  return Option(option_->check(
      numbers([](double x) { return x > 0 && std::isfinite(x); }, "greater than 0")));
}
Option Option::delimiter(char c) const { return Option(option_->delimiter(c)); }
Option Option::repeatable() const { return Option(option_->take_all()); }
Option Option::repeatable_value() const {
  return Option(option_->take_all()->allow_extra_args(false));
}
Option Option::needs(const Option& other) const { return Option(option_->needs(other.option_)); }
Option Option::excludes(const Option& other) const {
  return Option(option_->excludes(other.option_));
}

Option Command::option(const char* name, std::string& value, const std::string& help) const {
  return Option(app_->add_option(name, value, help));
}
Option Command::option(const char* name, std::vector<std::string>& values,
                       const std::string& help) const {
  return Option(app_->add_option(name, values, help));
}
Option Command::option(const char* name, std::vector<double>& values,
                       const std::string& help) const {
  return Option(app_->add_option(name, values, help));
}
Option Command::option(const char* name, double& value, const std::string& help) const {
  return Option(app_->add_option(name, value, help));
}
Option Command::option(const char* name, int& value, const std::string& help) const {
  return Option(app_->add_option(name, value, help));
}
Option Command::option(const char* name, std::int64_t& value, const std::string& help) const {
  return Option(app_->add_option(name, value, help));
}
Option Command::flag(const char* name, bool& value, const std::string& help) const {
  return Option(app_->add_flag(name, value, help));
}
void Command::footer(const std::string& text) const { app_->footer(text); }
void Command::action(const std::function<int()>& run) const {
  app_->callback([run, code = code_] { *code = run(); });
}

Program::Program(const std::string& description, const std::string& name,
                 const std::string& version)
    : app_(std::make_unique<CLI::App>(description, name)) {
  app_->set_version_flag("--version", version);
  app_->require_subcommand(1);
  app_->failure_message([](const CLI::App* a, const CLI::Error& e) {
    return fmt::format("error: {}; see {} --help\n", e.what(), a->get_name());
  });
}
Program::~Program() = default;

Command Program::add(const char* name, const char* description) {
  return {app_->add_subcommand(name, description), &code_};
}
void Program::footer(const std::string& text) { app_->footer(text); }

namespace {

/// CLI11 would only report that a subcommand is required; this names the unknown word.
void reject_unknown_command(const CLI::App& app, const std::string& word) {
  const bool option = word.starts_with('-');
  if (option && app.get_option_no_throw(word)) return;
  std::vector<std::string> names;
  for (const CLI::App* command : app.get_subcommands({})) names.push_back(command->get_name());
  if (!option && std::find(names.begin(), names.end(), word) != names.end()) return;
  throw Error(Error::Kind::scene, "",
              fmt::format("no {} {}; the commands are {}; see freshet --help",
                          option ? "option" : "command", word, fmt::join(names, ", ")));
}

}  // namespace

int Program::run(int argc, char** argv) {
  if (argc > 1) reject_unknown_command(*app_, argv[1]);
  try {
    app_->parse(argc, argv);
  } catch (const CLI::ParseError& e) {
    std::ostringstream out, error;
    const int code = app_->exit(e, out, error);
    put_text(out.str());
    put_error(error.str());
    return code == 0 ? done : usage;
  }
  return code_;
}

std::vector<Program::CommandHelp> Program::help() const {
  std::vector<CommandHelp> all;
  for (const CLI::App* command : app_->get_subcommands({})) {
    all.push_back({command->get_name(), command->get_description(), {}});
    for (const CLI::Option* option : command->get_options())
      for (const std::string& name : option->get_lnames())
        all.back().options.push_back({name, option->get_description()});
  }
  return all;
}

}  // namespace freshet::cli
