// SPDX-License-Identifier: MIT
/// Other programs, each in a process of its own.
#pragma once
#include <sys/types.h>

#include <chrono>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "io/files.h"

namespace freshet {

/// Whether a folder of PATH has an executable file of this name.
bool in_path(const std::string& program);

/// A program that PATH has. It is started without a shell, in a process group of its own: Ctrl-C
/// ends only the run, which then decides about the program. Its standard output and standard error
/// are kept.
class ChildProcess {
 public:
  /// Where its standard input comes from.
  enum class Input { empty, pipe };
  /// `words`: the program and its arguments. Throws Error (kind run) at `file`, what the program is
  /// to make, if it cannot be started.
  ChildProcess(const std::filesystem::path& file, std::vector<std::string> words, Input input);
  /// Ends the input and waits.
  ~ChildProcess();
  ChildProcess(const ChildProcess&) = delete;
  ChildProcess& operator=(const ChildProcess&) = delete;

  /// Writes to the pipe. Returns false if the program does not read it to the end.
  bool send(std::string_view bytes) const;
  /// Whether the program ends within this time. The input is not ended.
  bool ends_within(std::chrono::milliseconds time);
  /// Asks the program to end (SIGTERM) and waits.
  void stop();
  /// Ends the input and waits. Returns whether the program ended with exit code 0.
  bool finish();
  /// The last bytes of its output, or all.
  std::string output(std::size_t most) const;

 private:
  std::string name_;
  Descriptor pipe_, output_;
  pid_t process_ = -1;
  int status_ = -1;
};

}  // namespace freshet
