// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <cerrno>
#include <csignal>
#include <cstring>
#include <exception>
#include <new>

#include "command.h"
#include "freshet/version.h"

namespace freshet::cli {
namespace {

int run_program(int argc, char** argv) {
  Program program("Freshet: smoothed particle hydrodynamics", "freshet",
                  "freshet " FRESHET_VERSION);
  program.footer(
      "Examples:\n  freshet run article\n  freshet run my_scene.toml --set time.end=1\n"
      "  freshet scenes");
  add_run(program, {argv, argv + argc});
  add_resume(program, {argv, argv + argc});
  add_render(program);
  add_check(program);
  add_info(program);
  add_scenes(program);
  add_bench(program);
  add_plot(program);
  add_validate(program);
  add_schema(program);
  add_completion(program);
  return program.run(argc, argv);
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
