#pragma once

// Ends that come from outside: Ctrl-C, a request to terminate, a terminal that closes.
//
// Handled by real handlers, because a library's threads, which exist before main, would take a
// signal that only our own threads block. The handlers do nothing but pass a byte to a thread.

#include <filesystem>

#include "core/base/result.h"

namespace cutis {

// From now on the first interrupt calls `handler` on a thread of its own; the second removes all
// temporary files and ends the process with status 130. A terminal that closes counts where this
// was not asked to be ignored (nohup). Writing into a closed pipe or beyond the limit of a file's
// size is an error of that write and no end of the process. Fails where no thread can be had. Call
// once.
Status onInterrupt(void (*handler)());

// Whether an interrupt came, or interrupt() was called. Any thread, at any time.
bool isInterrupted();

// For a window that closes: reading that waits for others gives up.
void interrupt();

}  // namespace cutis
