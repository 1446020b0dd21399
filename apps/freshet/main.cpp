// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <csignal>
#include <exception>
#include <new>

#include "command.h"
#include "freshet/version.h"

namespace freshet::cli {
namespace {

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
  add_check(app, code);
  add_info(app, code);
  add_scenes(app, code);
  add_bench(app, code);
  add_schema(app, code);
  add_completion(app, code);
  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& e) {
    return app.exit(e) == 0 ? done : usage;
  }
  return code;
}

}  // namespace
}  // namespace freshet::cli

int main(int argc, char** argv) {
  // A full disk or a reader that went away is an error that is told, not a signal that kills.
  std::signal(SIGXFSZ, SIG_IGN);
  std::signal(SIGPIPE, SIG_IGN);
  try {
    return freshet::cli::run_program(argc, argv);
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
