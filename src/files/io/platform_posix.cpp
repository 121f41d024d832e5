#include <cstdlib>
#include <dlfcn.h>
#include <fcntl.h>
#include <fstream>
#include <pthread.h>
#include <signal.h>
#include <sys/resource.h>
#include <thread>
#include <unistd.h>

#include "src/files/io/platform.h"

#if defined(__GLIBC__)
#include <malloc.h>
#endif

namespace cutis {
namespace {

// A line of /proc/self/status; 0 where there is none.
std::size_t statusBytes(const std::string& name) {
  std::ifstream file("/proc/self/status");
  for (std::string line; std::getline(file, line);) {
    if (line.starts_with(name)) return std::strtoull(line.c_str() + name.size(), nullptr, 10) << 10;
  }
  return 0;
}

}  // namespace

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

unsigned long processId() {
  return static_cast<unsigned long>(::getpid());
}

std::filesystem::path cacheFolder() {
  if (const char* folder = std::getenv("XDG_CACHE_HOME"); folder != nullptr && *folder == '/') {
    return std::filesystem::path(folder) / "cutis";
  }
  if (const char* home = std::getenv("HOME"); home != nullptr && *home == '/') {
    return std::filesystem::path(home) / ".cache" / "cutis";
  }
  return {};
}

std::optional<std::size_t> restartPeakMemory() {
#if defined(__linux__) && defined(__GLIBC__)
  // Freed memory that is kept for later would be there already when it is needed.
  ::malloc_trim(0);
  // proc(5): 5 sets the peak to what is resident.
  std::ofstream restart("/proc/self/clear_refs");
  restart << '5' << std::flush;
  const std::size_t held = statusBytes("VmRSS:");
  if (restart && held > 0) return held;
#endif
  return {};
}

std::size_t peakMemoryBytes() {
  // Not of a parent before this program began, as getrusage() may report.
  if (const std::size_t peak = statusBytes("VmHWM:"); peak > 0) return peak;
  rusage usage = {};
  if (::getrusage(RUSAGE_SELF, &usage) != 0) return 0;
  return static_cast<std::size_t>(usage.ru_maxrss) * 1024;
}

void* moduleSymbol(const std::string& module, const char* symbol) {
  std::error_code error;
  const auto program = std::filesystem::read_symlink("/proc/self/exe", error);
  if (error) return nullptr;
  const auto file = program.parent_path() / (module + ".so");
  // Never closed: what it started, such as threads of a library, may outlive the call.
  void* opened = ::dlopen(file.c_str(), RTLD_NOW | RTLD_LOCAL);
  return opened == nullptr ? nullptr : ::dlsym(opened, symbol);
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

bool standardErrorIsTerminal() {
  return ::isatty(STDERR_FILENO) == 1;
}

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
