#include "src/cli/program.h"

int main(int argc, char** argv) {
  return cutis::runProgram(argc, argv);
}
