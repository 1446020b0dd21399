// SPDX-License-Identifier: MIT
/// Starts programs from tests and returns their exit status and output.
#pragma once
#include <fcntl.h>
#include <poll.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <chrono>
#include <csignal>
#include <cstdint>
#include <cstdlib>
#include <filesystem>
#include <optional>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace freshet::test {

/// Whether the program is built with a sanitizer, which takes terabytes of address space.
#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
inline constexpr bool sanitized = true;
#elif defined(__has_feature)
inline constexpr bool sanitized =
    __has_feature(address_sanitizer) || __has_feature(thread_sanitizer);
#else
inline constexpr bool sanitized = false;
#endif

/// A time limit finds hangs: the same input takes 10 to 15 times longer with a sanitizer.
inline constexpr double slowdown = sanitized ? 15 : 1;

struct ProcessOptions {
  std::filesystem::path directory = ".";
  std::vector<std::string> environment = {};     ///< NAME=VALUE, added to the test's own
  std::optional<std::uint64_t> file_limit = {};  ///< RLIMIT_FSIZE [B]
  double seconds = 60;                           ///< time limit, times `slowdown`; then killed [s]
  int signal = 0;                                ///< sent once `signal_after` was read from stdout
  std::string signal_after = {};
  bool close_stdout_early = false;                 ///< close the reading end after the first bytes
  std::string stdout_file = {};                    ///< instead of a pipe
  std::string stderr_file = {};                    ///< instead of a pipe
  bool close_stderr_early = false;                 ///< close the reading end after the first bytes
  std::vector<int> closed = {};                    ///< descriptors that the process starts without
  std::optional<std::uint64_t> memory_limit = {};  ///< RLIMIT_AS [B]
};

struct ProcessResult {
  int code = -1;     ///< exit code; -1 if a signal ended the process
  int ended_by = 0;  ///< the signal that ended the process, or 0
  bool timed_out = false;
  std::string out, err;
};

inline double now() {
  using namespace std::chrono;
  return duration<double>(steady_clock::now().time_since_epoch()).count();
}

/// Runs between fork and exec, where only async-signal-safe functions may be called.
[[noreturn]] inline void become(std::vector<char*>& argv, const ProcessOptions& o, int out,
                                int err) {
  setpgid(0, 0);  // a kill of the group reaches its children
  const int null = open("/dev/null", O_RDONLY);
  if (!o.stdout_file.empty()) out = open(o.stdout_file.c_str(), O_WRONLY);
  if (!o.stderr_file.empty()) err = open(o.stderr_file.c_str(), O_WRONLY);
  if (dup2(null, 0) < 0 || dup2(out, 1) < 0 || dup2(err, 2) < 0) _exit(126);
  if (chdir(o.directory.c_str()) != 0) _exit(126);
  for (const std::string& variable : o.environment) {
    const auto equals = variable.find('=');
    setenv(variable.substr(0, equals).c_str(), variable.c_str() + equals + 1, 1);
  }
  if (o.file_limit) {
    const rlimit limit{*o.file_limit, *o.file_limit};
    setrlimit(RLIMIT_FSIZE, &limit);
  }
  const rlimit no_core{0, 0};
  setrlimit(RLIMIT_CORE, &no_core);
  for (const int fd : o.closed) close(fd);
  if (o.memory_limit) {
    const rlimit limit{*o.memory_limit, *o.memory_limit};
    setrlimit(RLIMIT_AS, &limit);
  }
  execvp(argv[0], argv.data());
  _exit(127);
}

/// A running program; the destructor kills and reaps it.
class Process {
 public:
  Process(const std::vector<std::string>& command, ProcessOptions options = {});
  ~Process();
  Process(const Process&) = delete;
  Process& operator=(const Process&) = delete;

  /// Reads until stdout contains `text`; false if the program ended or the time limit was reached.
  bool wait_for(const std::string& text);
  /// Reads to the end of both pipes and reaps the program.
  ProcessResult finish();
  void send(int signal) const;

 private:
  bool read_some();  ///< false at the end of both pipes, or at the time limit
  void consume(int& fd, std::string& text, bool is_stdout);

  ProcessOptions options_;
  double deadline_;
  pid_t pid_ = -1;
  int out_ = -1, err_ = -1;
  ProcessResult result_;
};

inline Process::Process(const std::vector<std::string>& command, ProcessOptions options)
    : options_(std::move(options)), deadline_(now() + options_.seconds * slowdown) {
  std::vector<std::string> words = command;
  std::vector<char*> argv;
  for (std::string& word : words) argv.push_back(word.data());
  argv.push_back(nullptr);
  std::array<int, 2> out{}, err{};
  if (pipe2(out.data(), O_CLOEXEC) != 0 || pipe2(err.data(), O_CLOEXEC) != 0)
    throw std::runtime_error("cannot open a pipe for a program under test");
  pid_ = fork();
  if (pid_ < 0) throw std::runtime_error("cannot start a program under test");
  if (pid_ == 0) become(argv, options_, out[1], err[1]);
  close(out[1]);
  close(err[1]);
  out_ = out[0];
  err_ = err[0];
}

inline Process::~Process() {
  if (pid_ > 0) {
    kill(-pid_, SIGKILL);
    waitpid(pid_, nullptr, 0);
  }
  if (out_ >= 0) close(out_);
  if (err_ >= 0) close(err_);
}

inline void Process::send(int signal) const {
  if (pid_ > 0) kill(pid_, signal);
}

inline void Process::consume(int& fd, std::string& text, bool is_stdout) {
  std::array<char, 65536> buffer;
  const ssize_t n = read(fd, buffer.data(), buffer.size());
  if (n > 0) text.append(buffer.data(), std::size_t(n));
  const bool early = is_stdout ? options_.close_stdout_early : options_.close_stderr_early;
  if (n <= 0 || early) close(std::exchange(fd, -1));
  if (is_stdout && options_.signal != 0 && text.find(options_.signal_after) != std::string::npos) {
    send(options_.signal);
    options_.signal = 0;
  }
}

inline bool Process::read_some() {
  if (out_ < 0 && err_ < 0) return false;
  std::array<pollfd, 2> fds{pollfd{out_, POLLIN, 0}, pollfd{err_, POLLIN, 0}};
  const double left = deadline_ - now();
  if (left <= 0 || poll(fds.data(), fds.size(), int(left * 1000) + 1) <= 0) {
    result_.timed_out = true;
    kill(-pid_, SIGKILL);
    return false;
  }
  if (fds[0].revents != 0) consume(out_, result_.out, true);
  if (fds[1].revents != 0) consume(err_, result_.err, false);
  return true;
}

inline bool Process::wait_for(const std::string& text) {
  while (result_.out.find(text) == std::string::npos)
    if (!read_some()) return false;
  return true;
}

inline ProcessResult Process::finish() {
  while (read_some()) {
  }
  int status = 0;
  waitpid(std::exchange(pid_, -1), &status, 0);
  if (WIFEXITED(status)) result_.code = WEXITSTATUS(status);
  if (WIFSIGNALED(status)) result_.ended_by = WTERMSIG(status);
  return result_;
}

/// Runs the command to its end. Its first word is looked up in PATH if it has no slash.
inline ProcessResult run_process(const std::vector<std::string>& command,
                                 ProcessOptions options = {}) {
  return Process(command, std::move(options)).finish();
}

/// The command line of this build's `freshet` with these arguments.
inline std::vector<std::string> freshet_command(std::vector<std::string> arguments) {
  arguments.insert(arguments.begin(), FRESHET_PROGRAM);
  return arguments;
}

/// Runs this build's `freshet` with these arguments.
inline ProcessResult freshet(std::vector<std::string> arguments, ProcessOptions options = {}) {
  return run_process(freshet_command(std::move(arguments)), std::move(options));
}

}  // namespace freshet::test
