// SPDX-License-Identifier: MIT
#include "command_line.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cmath>
#include <set>
#include <sstream>

#include "freshet/error.h"
#include "freshet/suggest.h"
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
Option Option::value(const std::string& name) const { return Option(option_->type_name(name)); }
Option Option::one_of(const std::vector<std::string>& values) const {
  const auto fault = [values](const std::string& text) {
    return std::find(values.begin(), values.end(), text) != values.end()
               ? std::string()
               : fmt::format("\"{}\" is not allowed; choose one of {}", text,
                             fmt::join(values, ", "));
  };
  return value(fmt::format("{}", fmt::join(values, "|"))).check(fault);
}
Option Option::check(const std::function<std::string(const std::string&)>& fault) const {
  return Option(option_->check(CLI::Validator(fault, "")));
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

namespace {

/// A positional argument has a name that says what it is; CLI11 would print the type as well.
template <class Value>
CLI::Option* add(CLI::App* app, const char* name, Value& value, const std::string& help) {
  CLI::Option* option = app->add_option(name, value, help);
  return name[0] == '-' ? option : option->type_name("");
}

}  // namespace

Option Command::option(const char* name, std::string& value, const std::string& help) const {
  const auto fault = [](const std::string& text) {
    return std::string(text.empty() ? "an empty value is not allowed" : "");
  };
  return Option(add(app_, name, value, help)->check(CLI::Validator(fault, "")));
}
Option Command::option(const char* name, std::vector<std::string>& values,
                       const std::string& help) const {
  return Option(add(app_, name, values, help));
}
Option Command::option(const char* name, std::vector<double>& values,
                       const std::string& help) const {
  return Option(add(app_, name, values, help));
}
Option Command::option(const char* name, double& value, const std::string& help) const {
  return Option(add(app_, name, value, help));
}
Option Command::option(const char* name, int& value, const std::string& help) const {
  return Option(add(app_, name, value, help));
}
Option Command::option(const char* name, std::int64_t& value, const std::string& help) const {
  constexpr double most = 9007199254740992.0;  // 2^53; CLI11 replaces what 64 bits cannot hold
  const auto fits = numbers([](double x) { return std::abs(x) <= most; }, "of at most 2^53");
  return Option(add(app_, name, value, help)->check(fits));
}
Option Command::choice(const char* name, const std::vector<std::string>& values,
                       const std::function<void(int)>& set, const std::string& help) const {
  const auto take = [values, set](const std::string& value) {
    set(int(std::find(values.begin(), values.end(), value) - values.begin()));
  };
  return Option(app_->add_option_function<std::string>(name, take, help)).one_of(values);
}
Option Command::flag(const char* name, bool& value, const std::string& help) const {
  return Option(app_->add_flag(name, value, help));
}
void Command::footer(const std::string& text) const { app_->footer(text); }
void Command::action(const std::function<int()>& run) const {
  app_->callback([run, code = code_] { *code = run(); });
}

namespace {

/// What the user may have meant by a word that is not one of `words`: "did you mean --set?", or
/// nothing.
std::string did_you_mean(const std::string& typed, const std::vector<std::string>& words) {
  const std::string guess =
      nearest(typed, std::set<std::string, std::less<>>(words.begin(), words.end()));
  return guess.empty() ? "" : fmt::format("did you mean {}?", guess);
}

std::vector<std::string> long_options(const CLI::App& app) {
  std::vector<std::string> all;
  for (const CLI::Option* option : app.get_options())
    for (const std::string& name : option->get_lnames()) all.push_back("--" + name);
  return all;
}

/// One line with the remedy and the command's help.
std::string failure_text(const CLI::App* program, const CLI::Error& e) {
  const auto parsed = program->get_subcommands();
  const CLI::App& at = parsed.empty() ? *program : *parsed.front();
  std::string message = e.what();
  const auto unknown = at.remaining();
  if (e.get_exit_code() == int(CLI::ExitCodes::ExtrasError) && !unknown.empty()) {
    const std::string word = unknown.front().substr(0, unknown.front().find('='));
    const std::string guess = did_you_mean(word, long_options(at));
    message = word.starts_with('-') ? "no option " + word : "one argument too many: " + word;
    if (!guess.empty()) message += "; " + guess;
  }
  return fmt::format("error: {}; see {}{} --help\n", message, program->get_name(),
                     parsed.empty() ? "" : " " + at.get_name());
}

}  // namespace

Program::Program(const std::string& description, const std::string& name,
                 const std::string& version)
    : app_(std::make_unique<CLI::App>(description, name)) {
  app_->set_version_flag("--version", version);
  app_->require_subcommand(1);
  app_->failure_message(failure_text);
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
  std::string guess = did_you_mean(word, option ? long_options(app) : names);
  if (guess.empty()) guess = fmt::format("the commands are {}", fmt::join(names, ", "));
  throw Error(
      Error::Kind::scene, "",
      fmt::format("no {} {}; {}; see freshet --help", option ? "option" : "command", word, guess));
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
    CommandHelp help{
        command->get_name(), command->get_description(), command->get_footer(), {}, {}};
    for (const CLI::Option* option : command->get_options()) {
      const bool repeatable = option->get_items_expected_max() > 1;
      const std::string type = option->get_type_size() == 0 ? "" : option->get_type_name();
      for (const std::string& name : option->get_lnames())
        help.options.push_back({"--" + name, type, option->get_description(), repeatable});
      if (option->get_positional())
        help.positionals.push_back({option->get_name(true),
                                    type.empty() ? option->get_name(true) : type,
                                    option->get_description(), repeatable});
    }
    all.push_back(std::move(help));
  }
  return all;
}

}  // namespace freshet::cli
