#include "src/cli/program.h"
#include "src/files/system/error_stream.h"
#include "src/files/system/last_words.h"

int main(int argc, char** argv) {
  cutis::keepStandardStreams();
  cutis::endWellWithoutMemory("cutis-cli");
  return cutis::runProgram(argc, argv);
}
