// SPDX-License-Identifier: MIT
#include <host/attach/interruption.hpp>

#include <csignal>
#include <initializer_list>

namespace host {

namespace {

volatile std::sig_atomic_t came = 0;

extern "C" void note_and_reset(int signal) {
  came = 1;
  std::signal(signal, SIG_DFL);
}
extern "C" void note(int) { came = 1; }

}  // namespace

void watch_for_interruption(SecondSignal second) {
  const bool waits = second == SecondSignal::waits;
  for (const int signal : {SIGINT, SIGTERM, SIGHUP}) std::signal(signal, waits ? note : note_and_reset);
  if (!waits) return;
  std::signal(SIGQUIT, note);
  // Writing to a reader that has gone fails then, instead of ending the program.
  std::signal(SIGPIPE, SIG_IGN);
}

bool interrupted() { return came != 0; }

}  // namespace host
