// SPDX-License-Identifier: MIT
/// The command line: a program with subcommands and their options. CLI11 stays in
/// command_line.cpp, as every file that includes it takes seconds to compile.
#pragma once
#include <cstdint>
#include <functional>
#include <memory>
#include <string>
#include <vector>

namespace CLI {
class App;
class Option;
}  // namespace CLI

namespace freshet::cli {

enum ExitCode { done = 0, failed = 1, usage = 2, interrupted = 130 };

/// An option, or a positional argument, whose values can be limited.
class Option {
 public:
  explicit Option(CLI::Option* option) : option_(option) {}
  Option required() const;
  /// What the value is, for the help text and for completion: SCENE, DIR (of a run), CASE, SOLVER,
  /// KEY, KEY=VALUE, FILE, FOLDER. The name of a positional argument is that of its value.
  Option value(const std::string& name) const;
  Option one_of(const std::vector<std::string>& values) const;
  Option range(int min, int max) const;
  Option at_least(int min) const;
  Option range(double min, double max) const;
  Option positive() const;
  /// Values may stand in one word, with this character between them.
  Option delimiter(char c) const;
  /// The option may be used again and again, with one value or several each time.
  Option repeatable() const;
  /// The option may be used again and again, with one value each time.
  Option repeatable_value() const;
  Option needs(const Option& other) const;
  Option excludes(const Option& other) const;

 private:
  /// `fault` returns what is wrong with a value, or nothing.
  Option check(const std::function<std::string(const std::string&)>& fault) const;

  CLI::Option* option_;
};

/// A subcommand. The values must outlive the parsing.
class Command {
 public:
  Command(CLI::App* app, int* code) : app_(app), code_(code) {}
  /// "--name", or "NAME" for a positional argument.
  Option option(const char* name, std::string& value, const std::string& help) const;
  Option option(const char* name, std::vector<std::string>& values, const std::string& help) const;
  Option option(const char* name, std::vector<double>& values, const std::string& help) const;
  Option option(const char* name, double& value, const std::string& help) const;
  Option option(const char* name, int& value, const std::string& help) const;
  Option option(const char* name, std::int64_t& value, const std::string& help) const;
  /// Calls `set` with the place of the value in `values`.
  Option choice(const char* name, const std::vector<std::string>& values,
                const std::function<void(int)>& set, const std::string& help) const;
  Option flag(const char* name, bool& value, const std::string& help) const;
  /// The end of the help text.
  void footer(const std::string& text) const;
  /// Called after the arguments are parsed; returns the exit code.
  void action(const std::function<int()>& run) const;

 private:
  CLI::App* app_;
  int* code_;
};

class Program {
 public:
  Program(const std::string& description, const std::string& name, const std::string& version);
  ~Program();
  Command add(const char* name, const char* description);
  void footer(const std::string& text);

  /// Parses the arguments and runs a command. Returns the exit code.
  /// Throws Error (kind scene) for an unknown command.
  int run(int argc, char** argv);

  struct OptionHelp {
    std::string name;   ///< "--set", or "SCENE" for a positional argument
    std::string value;  ///< see Option::value; "a|b" for a choice, empty for a flag
    std::string description;
    bool repeatable = false;
  };
  struct CommandHelp {
    std::string name, description, footer;
    std::vector<OptionHelp> options, positionals;
  };
  /// The commands with their arguments.
  std::vector<CommandHelp> help() const;

 private:
  std::unique_ptr<CLI::App> app_;
  int code_ = done;
};

}  // namespace freshet::cli
