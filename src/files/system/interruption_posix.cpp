#include <atomic>
#include <cerrno>
#include <fcntl.h>
#include <signal.h>
#include <system_error>
#include <thread>
#include <unistd.h>

#include "src/files/system/interruption.h"
#include "src/files/system/temporary_path.h"

namespace cutis {
namespace {

constexpr int kInterruptedStatus = 130;
// Where the thread that ends the process does not get to it.
constexpr int kPatience = 3;

std::atomic<int> interrupts = 0;
static_assert(std::atomic<int>::is_always_lock_free, "used by handlers of signals");
int pipeEnds[2] = {-1, -1};

extern "C" void passOn(int) {
  const int kept = errno;
  if (interrupts.fetch_add(1) + 1 > kPatience) ::_exit(kInterruptedStatus);
  const char byte = 0;
  static_cast<void>(!::write(pipeEnds[1], &byte, 1));
  errno = kept;
}

void waitForByte() {
  char byte = 0;
  while (::read(pipeEnds[0], &byte, 1) < 0 && errno == EINTR) {
  }
}

void handle(int signal) {
  struct sigaction action = {};
  action.sa_handler = passOn;
  action.sa_flags = SA_RESTART;
  ::sigaction(signal, &action, nullptr);
}

bool isIgnored(int signal) {
  struct sigaction action = {};
  return ::sigaction(signal, nullptr, &action) == 0 && action.sa_handler == SIG_IGN;
}

// Programs are started with signals blocked by some launchers, and then would never end.
void unblock() {
  sigset_t signals;
  ::sigemptyset(&signals);
  for (const int signal : {SIGINT, SIGTERM, SIGHUP})
    ::sigaddset(&signals, signal);
  ::pthread_sigmask(SIG_UNBLOCK, &signals, nullptr);
}

}  // namespace

Status onInterrupt(void (*handler)()) {
  const Error failure = resourceError("", "not enough memory to start; close other programs");
  if (::pipe2(pipeEnds, O_CLOEXEC) != 0) return failure;
  try {
    std::thread([handler] {
      waitForByte();
      handler();
      waitForByte();
      removeTemporaries();
      ::_exit(kInterruptedStatus);
    }).detach();
  } catch (const std::system_error&) {
    return failure;
  }
  // What was ignored at the start stays so: nohup asks for it, and shells do for jobs in the
  // background.
  for (const int signal : {SIGINT, SIGTERM, SIGHUP}) {
    if (!isIgnored(signal)) handle(signal);
  }
  for (const int signal : {SIGPIPE, SIGXFSZ})
    ::signal(signal, SIG_IGN);
  unblock();
  return {};
}

bool isInterrupted() {
  return interrupts.load() > 0;
}

void interrupt() {
  interrupts.fetch_add(1);
}

}  // namespace cutis
