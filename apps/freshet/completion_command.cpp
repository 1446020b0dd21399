// SPDX-License-Identifier: MIT
#include <fmt/format.h>
#include <fmt/ranges.h>

#include "command.h"
#include "print.h"

namespace freshet::cli {
namespace {

std::vector<std::string> options_of(const Program::CommandHelp& command) {
  std::vector<std::string> names;
  for (const auto& option : command.options) names.push_back("--" + option.name);
  return names;
}

std::string bash(const Program& program) {
  std::string names, cases;
  for (const auto& command : program.help()) {
    names += command.name + " ";
    cases +=
        fmt::format("    {}) words=\"{}\" ;;\n", command.name, fmt::join(options_of(command), " "));
  }
  return fmt::format(R"sh(_freshet() {{
  local current="${{COMP_WORDS[COMP_CWORD]}}" words
  if [ "$COMP_CWORD" -eq 1 ]; then
    COMPREPLY=($(compgen -W "{}--help --version" -- "$current"))
    return
  fi
  case "${{COMP_WORDS[1]}}" in
{}  esac
  if [ "$COMP_CWORD" -eq 2 ] && [ "${{COMP_WORDS[1]}}" != plot ]; then
    words="$words $(freshet scenes --names 2>/dev/null)"
  fi
  COMPREPLY=($(compgen -W "$words" -- "$current") $(compgen -f -- "$current"))
}}
complete -F _freshet freshet
)sh",
                     names, cases);
}

std::string zsh(const Program& program) {
  return "autoload -U +X bashcompinit && bashcompinit\n" + bash(program);
}

std::string fish(const Program& program) {
  std::string out;
  for (const auto& command : program.help()) {
    out += fmt::format("complete -c freshet -n __fish_use_subcommand -a {} -d '{}'\n", command.name,
                       command.description);
    for (const auto& option : command.options)
      out += fmt::format("complete -c freshet -n '__fish_seen_subcommand_from {}' -l {} -d '{}'\n",
                         command.name, option.name, option.description);
  }
  return out +
         "complete -c freshet -n '__fish_seen_subcommand_from run check info bench' "
         "-a '(freshet scenes --names)'\n";
}

}  // namespace

void add_completion(Program& program) {
  const auto shell = std::make_shared<std::string>();
  const Command command = program.add("completion", "Print the completion of a shell");
  command.option("SHELL", *shell, "bash, zsh or fish").required().one_of({"bash", "zsh", "fish"});
  command.footer("Example:\n  source <(freshet completion bash)");
  command.action([shell, &program] {
    put(*shell == "bash" ? bash(program) : *shell == "zsh" ? zsh(program) : fish(program));
    return done;
  });
}

}  // namespace freshet::cli
