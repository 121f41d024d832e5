#include "src/files/io/atomic_write.h"

#include <cerrno>
#include <fstream>
#include <string>
#include <system_error>

#include "src/files/io/output_target.h"
#include "src/files/system/platform.h"
#include "src/files/system/temporary_path.h"

namespace cutis {

namespace fs = std::filesystem;

namespace {

// reason: what the system said, an errno.
Error cannotBeWritten(const fs::path& path, int reason) {
  const std::error_code said(reason, std::generic_category());
  const bool isFull = said == std::errc::no_space_on_device;
  return resourceError(path.string(), "the file cannot be written (" +
                                          (reason == 0 ? "unknown reason" : said.message()) +
                                          "); " +
                                          (isFull ? "free some disk space" : "write elsewhere"));
}

}  // namespace

Status checkWritable(const fs::path& path) {
  CUTIS_TRY(target, outputTarget(path));
  static_cast<void>(target);
  return {};
}

Status writeAtomically(const fs::path& path,
                       const std::function<Status(const fs::path& temporary)>& write) {
  CUTIS_TRY(target, outputTarget(path));
  const TemporaryPath temporary(temporaryBeside(target));
  std::error_code error;
  const bool replaces = fs::exists(target, error);
  // What others may not read they may not read while it is written either.
  if (replaces && !createPrivateFile(temporary.path())) return cannotBeWritten(path, errno);
  CUTIS_CHECK(write(temporary.path()));
  // Whatever wrote it met a full disk without noticing.
  if (replaces && fs::is_empty(temporary.path(), error)) return cannotBeWritten(path, ENOSPC);
  if (replaces) keepAttributes(target, temporary.path());
  if (!flushToDisk(temporary.path())) return cannotBeWritten(path, errno);
  fs::rename(temporary.path(), target, error);
  if (error) {
    return resourceError(path.string(),
                         "the file cannot be put in place (" + error.message() + ")");
  }
  return {};
}

Status writeTextAtomically(const fs::path& path, std::string_view text) {
  return writeAtomically(path, [&](const fs::path& temporary) -> Status {
    errno = 0;
    std::ofstream stream(temporary, std::ios::binary);
    stream.write(text.data(), static_cast<std::streamsize>(text.size()));
    stream.close();
    if (!stream) return cannotBeWritten(path, errno);
    return {};
  });
}

}  // namespace cutis
