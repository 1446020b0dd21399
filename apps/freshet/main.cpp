// SPDX-License-Identifier: MIT
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cerrno>
#include <csignal>
#include <cstring>
#include <exception>
#include <new>

#include "command.h"
#include "freshet/version.h"

namespace freshet::cli {
namespace {

/// CLI11 would only say that a subcommand is required; this names the word that is none.
void refuse_unknown_command(const CLI::App& app, const std::string& word) {
  const bool option = word.starts_with('-');
  if (option && app.get_option_no_throw(word)) return;
  std::vector<std::string> names;
  for (const CLI::App* command : app.get_subcommands({})) names.push_back(command->get_name());
  if (!option && std::find(names.begin(), names.end(), word) != names.end()) return;
  throw Error(Error::Kind::scene, "",
              fmt::format("no {} {}; the commands are {}; see freshet --help",
                          option ? "option" : "command", word, fmt::join(names, ", ")));
}

int run_program(int argc, char** argv) {
  int code = done;
  CLI::App app("Freshet: smoothed particle hydrodynamics", "freshet");
  app.set_version_flag("--version", "freshet " FRESHET_VERSION);
  app.require_subcommand(1);
  app.failure_message([](const CLI::App* a, const CLI::Error& e) {
    return fmt::format("error: {}; see {} --help\n", e.what(), a->get_name());
  });
  app.footer(
      "Examples:\n  freshet run article\n  freshet run my_scene.toml --set time.end=1\n"
      "  freshet scenes");
  add_run(app, code, {argv, argv + argc});
  add_resume(app, code, {argv, argv + argc});
  add_render(app, code);
  add_check(app, code);
  add_info(app, code);
  add_scenes(app, code);
  add_bench(app, code);
  add_plot(app, code);
  add_validate(app, code);
  add_schema(app, code);
  add_completion(app, code);
  if (argc > 1) refuse_unknown_command(app, argv[1]);
  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& e) {
    return app.exit(e) == 0 ? done : usage;
  }
  return code;
}

/// What a command printed must have reached a disk that may be full; a reader that went away is
/// fine. (A run's words are not its result.)
int check_output(const std::string& command, int code) {
  if (code != done || command == "run" || command == "resume" || std::fflush(stdout) == 0 ||
      errno == EPIPE)
    return code;
  fmt::print(stderr, "error: cannot write to standard output: {}\n", std::strerror(errno));
  return failed;
}

}  // namespace
}  // namespace freshet::cli

int main(int argc, char** argv) {
  // A full disk or a reader that went away is an error that is told, not a signal that kills.
  std::signal(SIGXFSZ, SIG_IGN);
  std::signal(SIGPIPE, SIG_IGN);
  try {
    const int code = freshet::cli::run_program(argc, argv);
    return freshet::cli::check_output(argc > 1 ? argv[1] : "", code);
  } catch (const freshet::Error& e) {
    freshet::cli::print_diagnostics(e.diagnostics());
    return e.kind() == freshet::Error::Kind::scene ? freshet::cli::usage : freshet::cli::failed;
  } catch (const std::bad_alloc&) {
    fmt::print(stderr, "error: out of memory; make the particles' spacing larger\n");
  } catch (const std::exception& e) {
    fmt::print(stderr, "error: {}\n", e.what());
  }
  return freshet::cli::failed;
}
