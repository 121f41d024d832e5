#pragma once

// The one line of a program that has no memory left to put a sentence together with.

namespace cutis {

inline constexpr char kNoMemory[] =
    "not enough memory; use a smaller picture or close other programs";

// "PROGRAM: sentence" on the standard error. Allocates nothing.
void sayLastWords(const char* sentence);

// From now on an exception that nobody can catch any more, because a thread or a destructor threw
// it, removes all temporary files and ends the process with a line and status 4 where memory was
// what was missing. Any other is a fault of ours, and aborts. `program` must live as long as the
// process.
void endWellWithoutMemory(const char* program);

}  // namespace cutis
