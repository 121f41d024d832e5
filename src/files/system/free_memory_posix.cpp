#include "src/files/system/free_memory.h"

#if defined(__GLIBC__)
#include <malloc.h>
#endif

namespace cutis {

void giveFreeMemoryBack() {
#if defined(__GLIBC__)
  ::malloc_trim(0);
#endif
}

}  // namespace cutis
