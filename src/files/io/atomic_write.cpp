#include "src/files/io/atomic_write.h"

#include <fstream>
#include <string>
#include <system_error>

#include "src/files/io/output_target.h"
#include "src/files/io/platform.h"
#include "src/files/io/temporary_path.h"

namespace cutis {

namespace fs = std::filesystem;

namespace {

Error cannotBeWritten(const fs::path& path) {
  return resourceError(path.string(), "the file cannot be written to the disk; free some space");
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
  if (replaces && !createPrivateFile(temporary.path())) return cannotBeWritten(path);
  CUTIS_CHECK(write(temporary.path()));
  if (replaces && fs::is_empty(temporary.path(), error)) return cannotBeWritten(path);
  if (replaces) keepAttributes(target, temporary.path());
  if (!flushToDisk(temporary.path())) return cannotBeWritten(path);
  fs::rename(temporary.path(), target, error);
  if (error) {
    return resourceError(path.string(),
                         "the file cannot be put in place (" + error.message() + ")");
  }
  return {};
}

Status writeTextAtomically(const fs::path& path, std::string_view text) {
  return writeAtomically(path, [&](const fs::path& temporary) -> Status {
    std::ofstream stream(temporary, std::ios::binary);
    stream.write(text.data(), static_cast<std::streamsize>(text.size()));
    stream.close();
    if (!stream) {
      return resourceError(path.string(), "the file cannot be written; free some disk space");
    }
    return {};
  });
}

}  // namespace cutis
