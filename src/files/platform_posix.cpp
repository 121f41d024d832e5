#include <fcntl.h>
#include <pthread.h>
#include <signal.h>
#include <sys/resource.h>
#include <unistd.h>

#include <cstdlib>
#include <fstream>
#include <thread>

#include "src/files/platform.h"

namespace cutis {

bool flushToDisk(const std::filesystem::path& path) {
  const int descriptor = ::open(path.c_str(), O_RDONLY | O_CLOEXEC);
  if (descriptor < 0) return false;
  const bool flushed = ::fsync(descriptor) == 0;
  ::close(descriptor);
  return flushed;
}

bool folderIsWritable(const std::filesystem::path& folder) {
  return ::access(folder.c_str(), W_OK | X_OK) == 0;
}

unsigned long processId() { return static_cast<unsigned long>(::getpid()); }

std::filesystem::path cacheFolder() {
  if (const char* folder = std::getenv("XDG_CACHE_HOME"); folder != nullptr && *folder == '/') {
    return std::filesystem::path(folder) / "cutis";
  }
  if (const char* home = std::getenv("HOME"); home != nullptr && *home == '/') {
    return std::filesystem::path(home) / ".cache" / "cutis";
  }
  return {};
}

std::size_t peakMemoryBytes() {
  rusage usage = {};
  if (::getrusage(RUSAGE_SELF, &usage) != 0) return 0;
  return static_cast<std::size_t>(usage.ru_maxrss) * 1024;
}

std::string processorName() {
  std::ifstream file("/proc/cpuinfo");
  for (std::string line; std::getline(file, line);) {
    if (line.starts_with("model name")) {
      const auto colon = line.find(": ");
      return colon == std::string::npos ? std::string() : line.substr(colon + 2);
    }
  }
  return {};
}

bool standardErrorIsTerminal() { return ::isatty(STDERR_FILENO) == 1; }

void onInterrupt(void (*handler)()) {
  sigset_t signals;
  ::sigemptyset(&signals);
  ::sigaddset(&signals, SIGINT);
  ::sigaddset(&signals, SIGTERM);
  // Blocked everywhere and taken by one thread: no handler ever interrupts other code.
  ::pthread_sigmask(SIG_BLOCK, &signals, nullptr);
  std::thread([signals, handler] {
    int signal = 0;
    ::sigwait(&signals, &signal);
    handler();
    ::sigwait(&signals, &signal);
    ::_exit(130);
  }).detach();
}

}  // namespace cutis
