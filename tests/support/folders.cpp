#include "tests/support/folders.h"

namespace cutis::test {

std::filesystem::path sourceFolder() {
  return CUTIS_SOURCE_DIR;
}

std::filesystem::path buildFolder() {
  return CUTIS_BINARY_DIR;
}

}  // namespace cutis::test
