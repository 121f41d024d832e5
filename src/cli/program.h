#pragma once  // internal to src/cli

// The whole program: reads the command line, runs a command, says what went wrong. Returns the exit
// status: 0 done, 2 usage, 3 bad input, 4 resources, 130 interrupted.

namespace cutis {

int runProgram(int argc, const char* const* argv);

}  // namespace cutis
