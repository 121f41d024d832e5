#include <cerrno>
#include <csignal>
#include <cstdlib>
#include <cstring>
#include <dlfcn.h>
#include <fcntl.h>
#include <fstream>
#include <string_view>
#include <sys/resource.h>
#include <sys/stat.h>
#include <unistd.h>

#include "src/files/system/platform.h"

#if defined(__GLIBC__)
#include <malloc.h>
#endif
#if defined(__linux__)
#include <sys/xattr.h>
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

// The program's folder in the one that the variable names, or else in that place below the home.
std::filesystem::path userFolder(const char* variable, const char* belowHome) {
  if (const char* folder = std::getenv(variable); folder != nullptr && *folder == '/') {
    return std::filesystem::path(folder) / "cutis";
  }
  if (const char* home = std::getenv("HOME"); home != nullptr && *home == '/') {
    return std::filesystem::path(home) / belowHome / "cutis";
  }
  return {};
}

#if defined(__linux__)

// Access lists are among them, as system.posix_acl_access.
bool isKept(std::string_view name) {
  return name.starts_with("user.") || name == "system.posix_acl_access" ||
         name == "security.selinux";
}

void copyExtendedAttributes(const char* from, const char* to) {
  std::string names, value;
  ssize_t length = ::listxattr(from, nullptr, 0);
  if (length <= 0) return;
  names.resize(static_cast<std::size_t>(length));
  length = ::listxattr(from, names.data(), names.size());
  if (length <= 0) return;
  names.resize(static_cast<std::size_t>(length));  // each ends with a zero
  for (std::size_t at = 0; at < names.size(); at += std::strlen(&names[at]) + 1) {
    const char* name = &names[at];
    if (!isKept(name)) continue;
    const ssize_t size = ::getxattr(from, name, nullptr, 0);
    if (size < 0) continue;
    value.resize(static_cast<std::size_t>(size));
    if (::getxattr(from, name, value.data(), value.size()) == size) {
      static_cast<void>(::setxattr(to, name, value.data(), value.size(), 0));
    }
  }
}

#else

void copyExtendedAttributes(const char*, const char*) {}

#endif

}  // namespace

bool flushToDisk(const std::filesystem::path& path) {
  const int descriptor = ::open(path.c_str(), O_RDONLY | O_CLOEXEC);
  if (descriptor < 0) return false;
  const bool flushed = ::fsync(descriptor) == 0;
  ::close(descriptor);
  return flushed;
}

bool isWritable(const std::filesystem::path& path) {
  std::error_code ignored;
  const int wanted = std::filesystem::is_directory(path, ignored) ? W_OK | X_OK : W_OK;
  return ::faccessat(AT_FDCWD, path.c_str(), wanted, AT_EACCESS) == 0;
}

bool createPrivateFile(const std::filesystem::path& path) {
  const int descriptor =
      ::open(path.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, S_IRUSR | S_IWUSR);
  if (descriptor < 0) return false;
  return ::close(descriptor) == 0;
}

void keepAttributes(const std::filesystem::path& from, const std::filesystem::path& to) {
  struct stat was = {}, is = {};
  if (::stat(from.c_str(), &was) != 0 || ::stat(to.c_str(), &is) != 0) return;
  mode_t mode = was.st_mode & (S_IRWXU | S_IRWXG | S_IRWXO);
  constexpr auto kSame = static_cast<uid_t>(-1);
  if (is.st_gid != was.st_gid && ::chown(to.c_str(), kSame, was.st_gid) != 0) {
    mode &= ~static_cast<mode_t>(S_IRWXG) | ((mode & S_IRWXO) << 3);
  }
  copyExtendedAttributes(from.c_str(), to.c_str());
  static_cast<void>(::chmod(to.c_str(), mode));
  // Last, since only the owner may do the rest.
  if (is.st_uid != was.st_uid && ::chown(to.c_str(), was.st_uid, kSame) != 0) {
    // Ours from now on.
  }
}

unsigned long processId() {
  return static_cast<unsigned long>(::getpid());
}

bool isProcessAlive(unsigned long id) {
  return ::kill(static_cast<pid_t>(id), 0) == 0 || errno == EPERM;
}

std::filesystem::path cacheFolder() {
  return userFolder("XDG_CACHE_HOME", ".cache");
}

std::filesystem::path stateFolder() {
  return userFolder("XDG_STATE_HOME", ".local/state");
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
  const auto beside = program.parent_path();
  for (const auto& folder : {beside, beside.parent_path() / "lib" / "cutis" / "modules"}) {
    const auto file = folder / (module + ".so");
    // Never closed: what it started, such as threads of a library, may outlive the call.
    void* opened = ::dlopen(file.c_str(), RTLD_NOW | RTLD_LOCAL);
    if (opened != nullptr) return ::dlsym(opened, symbol);
  }
  return nullptr;
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

}  // namespace cutis
