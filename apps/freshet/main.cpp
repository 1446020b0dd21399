// SPDX-License-Identifier: MIT
#include <csignal>
#include <cstring>
#include <exception>
#include <new>

#include "command.h"
#include "freshet/version.h"
#include "idle_threads.h"
#include "memory.h"
#include "own_fonts.h"
#include "print.h"

namespace freshet::cli {
namespace {

int run_program(int argc, char** argv) {
  Program program("Freshet: smoothed particle hydrodynamics", "freshet",
                  "freshet " FRESHET_VERSION);
  program.footer(
      "Examples:\n  freshet run article\n  freshet new dam_break_2d my_scene.toml\n"
      "  freshet run my_scene.toml --set time.end=1\n"
      "  freshet scenes");
  add_run(program, {argv, argv + argc});
  add_resume(program, {argv, argv + argc});
  add_render(program);
  add_measure(program);
  add_surface(program);
  add_film(program);
  add_view(program);
  add_new(program);
  add_import(program);
  add_check(program);
  add_info(program);
  add_scenes(program);
  add_bench(program);
  add_plot(program);
  add_validate(program);
  add_schema(program);
  add_completion(program);
  add_complete(program);
  add_manual(program);
  return program.run(argc, argv);
}

/// What a command printed must have reached a disk that may be full; a reader that went away is
/// fine. (A run's words are not its result.)
int check_output(const std::string& command, int code) {
  if (code != done || command == "run" || command == "resume") return code;
  const int failure = output_failure();
  if (failure == 0) return code;
  print_error("error: cannot write to standard output: {}; make room, or print elsewhere\n",
              std::strerror(failure));
  return failed;
}

/// Runs the program and prints its errors, except that memory ran out.
int report_errors(int argc, char** argv) {
  try {
    return check_output(argc > 1 ? argv[1] : "", run_program(argc, argv));
  } catch (const Error& e) {
    print_diagnostics(e.diagnostics());
    return e.kind() == Error::Kind::scene ? usage : failed;
  } catch (const std::bad_alloc&) {
    throw;
  } catch (const std::exception& e) {
    print_error("error: {}\n", e.what());
  }
  return failed;
}

}  // namespace
}  // namespace freshet::cli

int main(int argc, char** argv) {
  freshet::cli::let_idle_threads_sleep(argc, argv);
  freshet::cli::fill_standard_descriptors();
  freshet::cli::find_own_fonts();
  freshet::cli::keep_memory_in_reserve();
  // A full disk or a reader that went away is an error that is told, not a signal that kills.
  std::signal(SIGXFSZ, SIG_IGN);
  std::signal(SIGPIPE, SIG_IGN);
  try {
    return freshet::cli::report_errors(argc, argv);
  } catch (const std::bad_alloc&) {
    freshet::cli::put_error(
        "error: out of memory; make particles.spacing larger, or free memory for the run\n");
  }
  return freshet::cli::failed;
}
