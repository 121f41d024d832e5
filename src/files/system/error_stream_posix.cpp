#include <fcntl.h>
#include <mutex>
#include <unistd.h>

#include "src/files/system/error_stream.h"

#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
#define CUTIS_REPORTS_ON_ERROR_STREAM 1
#else
#define CUTIS_REPORTS_ON_ERROR_STREAM 0
#endif

namespace cutis {
namespace {

constexpr int kFirstOther = 3;

// A second descriptor of the stream, which stays when the first is turned away.
int ownStream() {
  static const int own = ::fcntl(STDERR_FILENO, F_DUPFD_CLOEXEC, kFirstOther);
  return own;
}

// Guards the count of living silences.
std::mutex mutex;
int silences = 0;

void turnAway() {
  const int nowhere = ::open("/dev/null", O_WRONLY | O_CLOEXEC);
  if (nowhere < 0) return;
  ::dup2(nowhere, STDERR_FILENO);
  ::close(nowhere);
}

}  // namespace

LibrarySilence::LibrarySilence() {
  const std::scoped_lock lock(mutex);
  if (silences++ > 0 || CUTIS_REPORTS_ON_ERROR_STREAM || ownStream() < 0) return;
  turnAway();
}

LibrarySilence::~LibrarySilence() {
  const std::scoped_lock lock(mutex);
  if (--silences > 0 || CUTIS_REPORTS_ON_ERROR_STREAM || ownStream() < 0) return;
  ::dup2(ownStream(), STDERR_FILENO);
}

void writeError(std::string_view text) {
  while (!text.empty()) {
    const ssize_t count = ::write(ownStream(), text.data(), text.size());
    if (count <= 0) return;
    text.remove_prefix(static_cast<std::size_t>(count));
  }
}

void keepStandardStreams() {
  for (const int stream : {STDIN_FILENO, STDOUT_FILENO, STDERR_FILENO}) {
    if (::fcntl(stream, F_GETFD) < 0) static_cast<void>(::open("/dev/null", O_RDWR));
  }
  static_cast<void>(ownStream());
}

}  // namespace cutis
