#include "signals.hpp"

#include <unistd.h>

#include <csignal>

#include "skylut/core/atomic_file.hpp"

namespace skylut::cli {

namespace {

extern "C" void end_by_signal(int signal) {
  remove_unfinished_files();
  _exit(128 + signal);
}

}  // namespace

void end_cleanly_on_signals() {
  // Asked to stop, terminal closed, reader gone, and the limits on CPU time and file size.
  for (const int signal : {SIGINT, SIGTERM, SIGHUP, SIGPIPE, SIGXCPU, SIGXFSZ}) {
    struct sigaction action {};
    if (::sigaction(signal, nullptr, &action) != 0 || action.sa_handler == SIG_IGN) continue;
    action = {};
    action.sa_handler = end_by_signal;
    sigfillset(&action.sa_mask);
    ::sigaction(signal, &action, nullptr);
  }
}

}  // namespace skylut::cli
