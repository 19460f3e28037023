#pragma once

namespace insonate::cli {

/// Installs signal handlers: the first Ctrl-C or SIGTERM sets a flag that cancels the running work at its next progress
/// report, a second one ends the program at once.
void catchInterrupts();

/// Returns the number of the received signal (SIGINT or SIGTERM), 0 if none was received.
int interruptSignal();

}  // namespace insonate::cli
