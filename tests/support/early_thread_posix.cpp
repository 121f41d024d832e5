// A library to preload: starts a thread before main, as some libraries for linear algebra do.

#include <pthread.h>
#include <unistd.h>

namespace {

void* sleepForEver(void*) {
  for (;;)
    ::pause();
}

__attribute__((constructor)) void startThread() {
  pthread_t thread;
  ::pthread_create(&thread, nullptr, sleepForEver, nullptr);
}

}  // namespace
