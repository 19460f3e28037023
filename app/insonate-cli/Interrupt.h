#pragma once

namespace insonate::cli {

/// Makes the first Ctrl-C or SIGTERM only set a flag, which the running work checks at its next progress report. A
/// second signal ends the program at once.
void catchInterrupts();

/// Returns the number of the signal that was received, or 0.
int interruptSignal();

}  // namespace insonate::cli
