#pragma once  // internal to src/app/project

// The files of a source, and whether they are still what was read.

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "core/base/job_context.h"
#include "core/base/result.h"
#include "src/app/open/source.h"

namespace cutis {

struct SourceFile {
  std::filesystem::path path;  // absolute
  std::string hash;            // ContentHash of its bytes; empty while it is not known
  // As the file system told them when the file was last looked at.
  std::uintmax_t size = 0;
  std::filesystem::file_time_type modified = {};
};

// The files that are read for a source at `path` with these options, as they are now, still without
// hashes. To be called before they are read.
std::vector<SourceFile> listSourceFiles(const std::filesystem::path& path,
                                        const SourceOptions& options);

// Adds the hashes that are still missing: those that reading found, and of other files by reading
// them. A file that is another by now than when it was listed keeps none.
Status addHashes(const std::filesystem::path& path, const std::vector<SourceReference>& references,
                 std::vector<SourceFile>& files, const JobContext& context);

// The files that are there and hold something else than was read; each change is reported once.
// Files whose size and time are as they were are taken as unchanged.
Result<std::vector<std::filesystem::path>> changedFiles(std::vector<SourceFile>& files,
                                                        const JobContext& context);

// Those of the files that are not there.
std::vector<std::filesystem::path> missingFiles(const std::vector<SourceFile>& files);
// The first of them; empty if none is missing.
std::filesystem::path firstMissing(const std::vector<SourceFile>& files);

}  // namespace cutis
