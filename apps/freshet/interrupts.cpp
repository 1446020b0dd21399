// SPDX-License-Identifier: MIT
#include "interrupts.h"

#include <atomic>
#include <csignal>

namespace freshet::cli {
namespace {

std::atomic<bool> asked{false};

void on_signal(int signal, int flags) {
  struct sigaction action {};
  action.sa_handler = [](int) { asked = true; };
  action.sa_flags = flags;
  sigaction(signal, &action, nullptr);
}

}  // namespace

void catch_interrupts() {
  for (const int signal : {SIGINT, SIGTERM}) on_signal(signal, int(SA_RESETHAND));
  // A terminal that closes may send it twice, and nohup has it ignored.
  struct sigaction before {};
  sigaction(SIGHUP, nullptr, &before);
  if (before.sa_handler != SIG_IGN) on_signal(SIGHUP, 0);
}

bool stop_asked() { return asked; }

}  // namespace freshet::cli
