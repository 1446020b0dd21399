// SPDX-License-Identifier: MIT
#include "interrupts.h"

#include <atomic>
#include <csignal>

namespace freshet::cli {
namespace {

std::atomic<bool> asked{false};

}  // namespace

void catch_interrupts() {
  struct sigaction action {};
  action.sa_handler = [](int) { asked = true; };
  action.sa_flags = int(SA_RESETHAND);
  sigaction(SIGINT, &action, nullptr);
  sigaction(SIGTERM, &action, nullptr);
}

bool stop_asked() { return asked; }

}  // namespace freshet::cli
