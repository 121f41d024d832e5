#include "src/files/io/output_target.h"

#include <string>
#include <system_error>

#include "src/files/system/platform.h"

namespace cutis {

namespace fs = std::filesystem;

namespace {

// As many as Linux follows.
constexpr int kMostLinks = 40;

fs::path folderOf(const fs::path& path) {
  return path.has_parent_path() ? path.parent_path() : fs::path(".");
}

// Open files of a process: links whose targets are no paths, such as "pipe:[4242]".
bool isOpenStream(const fs::path& folder) {
  const std::string name = folder.string();
  return name.starts_with("/proc/") && name.ends_with("/fd");
}

Error missingFolder(const fs::path& path, const fs::path& link) {
  if (link == path) {
    return resourceError(path.string(), "the folder '" + folderOf(path).string() +
                                            "' does not exist; create it or write elsewhere");
  }
  return resourceError(path.string(), "this is a link to '" + link.string() +
                                          "', whose folder does not exist; mend the link or write "
                                          "elsewhere");
}

Result<fs::path> behindLinks(const fs::path& path) {
  fs::path link = path;
  for (int k = 0; k < kMostLinks; ++k) {
    std::error_code error;
    const fs::path folder = fs::canonical(folderOf(link), error);
    if (error == std::errc::permission_denied) {
      return resourceError(path.string(), "the folder '" + folderOf(link).string() +
                                              "' may not be entered; change its permissions or "
                                              "write elsewhere");
    }
    if (error || !fs::is_directory(folder, error)) return missingFolder(path, link);
    const fs::path file = folder / link.filename();
    if (!fs::is_symlink(file, error)) {
      // The name as it was given stands in fewer surprising messages than the canonical one.
      return k == 0 ? path : file;
    }
    if (isOpenStream(folder)) {
      return resourceError(path.string(),
                           "this stands for a stream that is open already, such as standard "
                           "output, and is not replaced; name a file to write");
    }
    const fs::path next = fs::read_symlink(file, error);
    if (error) break;
    link = next.is_absolute() ? next : folder / next;
  }
  return resourceError(path.string(),
                       "this is a link that leads to no file; mend the link or write elsewhere");
}

const char* objectionTo(fs::file_type type) {
  switch (type) {
    case fs::file_type::none:
    case fs::file_type::not_found:
    case fs::file_type::regular:
      return nullptr;
    case fs::file_type::directory:
      return "this is a folder; name a file to write";
    default:
      // A file would take the place of the device or the pipe.
      return "this is a device, a pipe or a socket and not a regular file; name a file to write";
  }
}

}  // namespace

Result<fs::path> outputTarget(const fs::path& path) {
  CUTIS_TRY(target, behindLinks(path));
  std::error_code error;
  const fs::file_status status = fs::status(target, error);
  if (error == std::errc::filename_too_long) {
    return resourceError(path.string(), "the name is too long for the disk; choose a shorter one");
  }
  if (const char* objection = objectionTo(status.type())) {
    return resourceError(path.string(), objection);
  }
  const fs::path folder = folderOf(target);
  if (!isWritable(folder)) {
    return resourceError(path.string(), "the folder '" + folder.string() +
                                            "' cannot be written to; write elsewhere");
  }
  if (fs::exists(status) && !isWritable(target)) {
    return resourceError(path.string(),
                         "the file is protected from being written to; change its permissions or "
                         "write elsewhere");
  }
  return target;
}

}  // namespace cutis
