// SPDX-License-Identifier: MIT
/// The completions of shells. They ask `freshet complete` for the words, so that all offer the
/// same.
#include "command.h"
#include "print.h"

namespace freshet::cli {
namespace {

constexpr const char* bash = R"sh(_freshet() {
  local IFS=$'\n' word lines
  COMPREPLY=()
  lines=$(freshet complete -- "${COMP_WORDS[@]:1:COMP_CWORD}" 2>/dev/null)
  for word in $lines; do
    if [ "$word" = "<files>" ]; then
      compopt -o filenames 2>/dev/null
      COMPREPLY+=($(compgen -f -- "${COMP_WORDS[COMP_CWORD]#=}"))
    else
      case "$word" in *=) compopt -o nospace 2>/dev/null ;; esac
      COMPREPLY+=("${word%%$'\t'*}")
    fi
  done
}
complete -F _freshet freshet
)sh";

constexpr const char* zsh = R"sh(#compdef freshet
_freshet() {
  local line
  local -a words_after
  words_after=("${(@)words[2,CURRENT]}")
  for line in "${(@f)$(freshet complete -- "${words_after[@]}" 2>/dev/null)}"; do
    case "$line" in
      '') ;;
      '<files>') _files ;;
      *=) compadd -S '' -- "$line" ;;
      *) compadd -- "${line%%$'\t'*}" ;;
    esac
  done
}
if [ "$funcstack[1]" = "_freshet" ]; then
  _freshet "$@"
else
  compdef _freshet freshet
fi
)sh";

constexpr const char* fish = R"sh(function __freshet_words
  set -l before (commandline -opc)
  for line in (freshet complete -- $before[2..-1] (commandline -ct) 2>/dev/null)
    if test "$line" = "<files>"
      __fish_complete_path (commandline -ct)
    else
      echo $line
    end
  end
end
complete -c freshet -f -a '(__freshet_words)'
)sh";

}  // namespace

void add_completion(Program& program) {
  const auto shell = std::make_shared<std::string>();
  const Command command = program.add("completion", "Print the completion of a shell");
  command.option("SHELL", *shell, "bash, zsh or fish").required().one_of({"bash", "zsh", "fish"});
  command.footer("Example:\n  source <(freshet completion bash)");
  command.action([shell] {
    put(*shell == "bash" ? bash : *shell == "zsh" ? zsh : fish);
    return done;
  });
}

}  // namespace freshet::cli
