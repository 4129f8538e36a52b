// SPDX-License-Identifier: MIT
//
// The user's wish to end (SIGINT, SIGTERM, SIGHUP), so that programs end in order: files whole, the terminal
// as it was, panels blanked, lines free.
#pragma once

namespace host {

/// What the same signal does when it comes again.
enum class SecondSignal {
  ends_at_once,  ///< As if nobody watched.
  waits,         ///< For the program's orderly end, too: what hangs on wires must not be left half written.
};

/// From now on these signals only set a flag; with `waits` SIGQUIT, too, and a reader that has gone (SIGPIPE)
/// makes writing fail.
void watch_for_interruption(SecondSignal second);

/// True once one has come.
[[nodiscard]] bool interrupted();

}  // namespace host
