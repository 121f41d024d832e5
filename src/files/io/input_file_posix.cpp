#include <cerrno>
#include <fcntl.h>
#include <poll.h>
#include <unistd.h>

#include "src/files/io/input_file.h"
#include "src/files/system/interruption.h"

namespace cutis {
namespace {

// Between two looks whether the program is interrupted.
constexpr int kWaitMs = 50;

}  // namespace

Result<InputFile> InputFile::open(const std::filesystem::path& path) {
  const int descriptor = ::open(path.c_str(), O_RDONLY | O_NONBLOCK | O_NOCTTY | O_CLOEXEC);
  if (descriptor >= 0) return InputFile(descriptor, path.string());
  if (errno == EMFILE || errno == ENFILE || errno == ENOMEM) {
    return resourceError(path.string(),
                         "the system lets no more files be opened; close other programs");
  }
  return inputError(path.string(), "the file cannot be opened; check its permissions");
}

InputFile::~InputFile() {
  if (descriptor_ >= 0) ::close(descriptor_);
}

Result<std::size_t> InputFile::read(std::span<char> bytes) {
  for (;;) {
    pollfd waiting = {descriptor_, POLLIN, 0};
    const int ready = ::poll(&waiting, 1, kWaitMs);
    if (isInterrupted()) return Cancelled{};
    if (ready <= 0) continue;
    const ssize_t count = ::read(descriptor_, bytes.data(), bytes.size());
    if (count >= 0) return static_cast<std::size_t>(count);
    if (errno == EINTR || errno == EAGAIN) continue;
    return inputError(place_, "the file cannot be read to its end; check the disk");
  }
}

}  // namespace cutis
