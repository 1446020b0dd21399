// SPDX-License-Identifier: MIT
/// The words that can follow on a command line. The completions of all shells ask the program for
/// them: `freshet complete -- WORD...`, the last word being the one to complete.
#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "command.h"
#include "freshet/scene_documents.h"
#include "freshet/solver_method.h"
#include "output_folder.h"
#include "print.h"

namespace freshet::cli {
namespace {

namespace fs = std::filesystem;
using Words = std::vector<std::string>;
using OptionHelp = Program::OptionHelp;
using CommandHelp = Program::CommandHelp;

/// Stands for the names of files, which the shell completes itself.
constexpr const char* files = "<files>";

/// The keys of a table of the schema, and those of the tables in it.
void add_keys(const nlohmann::json& table, const std::string& prefix, Words& all) {
  for (const auto& [name, key] : table.at("properties").items()) {
    const auto& inner = key.contains("oneOf") ? key.at("oneOf").front() : key;
    if (inner.contains("properties")) add_keys(inner, prefix + name + ".", all);
    else all.push_back(prefix + name);
  }
}

/// All keys of scenes, each with `end`.
Words keys(const char* end) {
  Words all;
  add_keys(nlohmann::json::parse(scene_schema()), "", all);
  for (std::string& key : all) key += end;
  return all;
}

/// The folders of runs below runs/. A scene in a folder has its run in a folder of that name.
Words runs() {
  Words all;
  std::error_code ec;
  for (fs::recursive_directory_iterator at("runs", ec), end; at != end; at.increment(ec)) {
    if (at.depth() >= 2) at.disable_recursion_pending();
    if (!at->is_directory(ec) || !holds_run(at->path())) continue;
    all.push_back(at->path().string());
    at.disable_recursion_pending();
  }
  std::sort(all.begin(), all.end());
  return all;
}

Words split(const std::string& text, char separator) {
  Words all;
  std::istringstream in(text);
  for (std::string word; std::getline(in, word, separator);) all.push_back(word);
  return all;
}

/// The values of an option or argument, by what its value is.
Words values(const std::string& value) {
  Words all;
  if (value.find('|') != std::string::npos) return split(value, '|');
  if (value == "SOLVER")
    for (const SolverMethod* m : solver_methods()) all.emplace_back(m->name);
  if (value == "SCENE")
    for (const auto& [name, file] : scenes_that_come_along()) all.push_back(name);
  if (value == "CASE") all = case_names();
  if (value == "DIR") all = runs();
  if (value == "KEY") return keys("");
  if (value == "KEY=VALUE" || value == "KEY=A,B") return keys("=");
  for (const char* file : {"SCENE", "CASE", "DIR", "FILE", "FOLDER"})
    if (value == file) all.emplace_back(files);
  return all;
}

const OptionHelp* find(const CommandHelp& command, const std::string& name) {
  for (const OptionHelp& option : command.options)
    if (option.name == name) return &option;
  return nullptr;
}

/// A word with what it does, which fish and zsh show.
std::string described(const std::string& word, const std::string& description) {
  return word + "\t" + description;
}

/// `words` follow the command; the last one is completed.
Words after_command(const CommandHelp& command, const Words& words) {
  std::size_t positionals = 0;
  const OptionHelp* open = nullptr;  // the option whose value comes next
  for (std::size_t k = 0; k + 1 < words.size(); ++k) {
    if (words[k].starts_with("--")) {
      open = find(command, words[k]);
      if (open && open->value.empty()) open = nullptr;
    } else if (open) {
      open = nullptr;
    } else {
      ++positionals;
    }
  }
  const std::string& current = words.back();
  if (open) return values(open->value);
  if (const auto equals = current.find('='); current.starts_with("--") && equals != current.npos) {
    const OptionHelp* option = find(command, current.substr(0, equals));
    Words all = option ? values(option->value) : Words();
    for (std::string& word : all)
      if (word != files) word = current.substr(0, equals + 1) + word;
    return all;
  }
  if (!current.starts_with('-') && !command.positionals.empty()) {
    const OptionHelp& last = command.positionals.back();
    if (positionals < command.positionals.size())
      return values(command.positionals[positionals].value);
    if (last.repeatable) return values(last.value);
  }
  Words all;
  for (const OptionHelp& option : command.options)
    all.push_back(described(option.name, option.description));
  return all;
}

/// Without the words "=" at which bash splits: "--solver", "=", "dfsph". False if the word to
/// complete is the value of a key, which nothing is known of.
bool join_at_equals(Words& words) {
  for (std::size_t k = 1; k < words.size(); ++k) {
    if (words[k] != "=") continue;
    if (!words[k - 1].starts_with("--")) {  // KEY=VALUE
      if (k + 2 >= words.size()) return false;
      words.erase(words.begin() + std::ptrdiff_t(k) + 1);
    } else if (k + 1 == words.size()) {
      words.emplace_back();
    }
    words.erase(words.begin() + std::ptrdiff_t(k));
  }
  return true;
}

Words candidates(const Program& program, Words words) {
  if (words.empty()) words.emplace_back();
  if (!join_at_equals(words)) return {};
  const auto commands = program.help();
  Words all;
  for (const CommandHelp& command : commands) {
    if (words.size() > 1 && command.name == words.front())
      return after_command(command, {words.begin() + 1, words.end()});
    all.push_back(described(command.name, command.description));
  }
  if (words.size() > 1) return {};
  all.push_back(described("--help", "Print this help message and exit"));
  all.push_back(described("--version", "Display program version information and exit"));
  return all;
}

bool completes(const std::string& candidate, const std::string& word) {
  return candidate == files || candidate.starts_with(word == "=" ? "" : word);
}

}  // namespace

void add_complete(Program& program) {
  const auto words = std::make_shared<Words>();
  const Command command =
      program.add("complete", "Print the words that can follow, for the completions of shells");
  command.option("WORD", *words, "the words so far, after freshet; the last one is completed");
  command.footer("Example:\n  freshet complete -- run art");
  command.action([words, &program] {
    const std::string word = words->empty() ? "" : words->back();
    for (const std::string& candidate : candidates(program, *words))
      if (completes(candidate, word)) print_out("{}\n", candidate);
    return done;
  });
}

}  // namespace freshet::cli
