#include <csignal>
#include <cstdlib>
#include <cstring>
#include <exception>
#include <new>
#include <system_error>
#include <unistd.h>

#include "src/files/system/error_stream.h"
#include "src/files/system/last_words.h"
#include "src/files/system/temporary_path.h"

namespace cutis {
namespace {

constexpr int kNoMemoryStatus = 4;

const char* program = "cutis";

bool isLackOfMemory() {
  const std::exception_ptr thrown = std::current_exception();
  if (!thrown) return false;
  try {
    std::rethrow_exception(thrown);
  } catch (const std::bad_alloc&) {
    return true;
  } catch (const std::system_error& error) {
    return error.code() == std::errc::resource_unavailable_try_again ||
           error.code() == std::errc::not_enough_memory;
  } catch (...) {
    return false;
  }
}

void onTerminate() {
  if (!isLackOfMemory()) std::abort();
  sayLastWords(kNoMemory);
  try {
    removeTemporaries();
  } catch (const std::exception&) {
    // Before main there are none.
  }
  ::_exit(kNoMemoryStatus);
}

#if !defined(__SANITIZE_ADDRESS__) && !defined(__SANITIZE_THREAD__)
// Some libraries use what they were not given while they set themselves up.
void onCrashOfLibrary(int) {
  sayLastWords(kNoMemory);
  ::_exit(kNoMemoryStatus);
}

void watchCrashes() {
  std::signal(SIGSEGV, onCrashOfLibrary);
}

// Set up after all libraries: from here on a crash is one.
struct LibrariesAreReady {
  LibrariesAreReady() { std::signal(SIGSEGV, SIG_DFL); }
};
const LibrariesAreReady kLibrariesAreReady;
#else
// Sanitizers report crashes.
void watchCrashes() {}
#endif

// Libraries need memory to set themselves up, which is before main(), and before everything of
// ours.
void watchLibraries(int, char** arguments, char**) {
  if (arguments != nullptr && arguments[0] != nullptr) {
    const char* slash = std::strrchr(arguments[0], '/');
    program = slash != nullptr ? slash + 1 : arguments[0];
  }
  std::set_terminate(onTerminate);
  watchCrashes();
}

#ifdef __linux__
[[gnu::section(".preinit_array"),
  gnu::used]] void (*const kBeforeLibraries)(int, char**, char**) = watchLibraries;
#endif

}  // namespace

void sayLastWords(const char* sentence) {
  for (const char* part : {program, ": ", sentence, "\n"}) {
    writeError(part);
  }
}

void endWellWithoutMemory(const char* name) {
  program = name;
  std::set_terminate(onTerminate);
}

}  // namespace cutis
