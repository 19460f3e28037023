#pragma once

namespace insonate::cli {

/// From now on Ctrl-C and SIGTERM only leave a mark, which the work sees at its next report; a second one ends the
/// program at once.
void catchInterrupts();

/// The signal that asked to stop, or 0.
int interruptSignal();

}  // namespace insonate::cli
