#include <cstdlib>
#include <unistd.h>

#include "tests/support/scratch_folder.h"

namespace cutis::test {
namespace {

constexpr uid_t kNobody = 65534;

}  // namespace

OrdinaryUser::OrdinaryUser() {
  // Root stays saved, so that the way back is open.
  if (::getuid() == 0 && ::setresuid(kNobody, kNobody, 0) != 0) std::abort();
}

OrdinaryUser::~OrdinaryUser() {
  if (::getuid() == kNobody && ::setresuid(0, 0, 0) != 0) {
    // Never was root.
  }
}

}  // namespace cutis::test
