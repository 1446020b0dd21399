// SPDX-License-Identifier: MIT
#include "output_folder.h"

#include <fmt/format.h>
#include <unistd.h>

#include <iostream>

#include "print.h"

namespace freshet::cli {

namespace fs = std::filesystem;

bool holds_run(const fs::path& folder) {
  std::error_code ec;
  return fs::exists(folder / "manifest.json", ec);
}

fs::path next_free(const fs::path& folder) {
  std::error_code ec;
  for (int k = 2;; ++k) {
    const fs::path next = fmt::format("{}-{}", folder.string(), k);
    if (!fs::exists(fs::symlink_status(next, ec))) return next;
  }
}

bool is_terminal() { return isatty(STDIN_FILENO) == 1 && isatty(STDERR_FILENO) == 1; }

bool ask(const std::string& question) {
  put_error(question);
  std::string answer;
  std::getline(std::cin, answer);
  return answer.starts_with('y') || answer.starts_with('Y');
}

}  // namespace freshet::cli
