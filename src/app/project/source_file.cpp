#include "src/app/project/source_file.h"

#include <algorithm>
#include <set>

#include "src/files/io/named_files.h"
#include "src/images/codec/source_file.h"

namespace cutis {
namespace {

namespace fs = std::filesystem;

// Whether the file could be asked; nothing is changed where it could not.
bool askFileSystem(SourceFile& file) {
  std::error_code error;
  const auto size = fs::file_size(file.path, error);
  if (error) return false;
  const auto modified = fs::last_write_time(file.path, error);
  if (error) return false;
  file.size = size;
  file.modified = modified;
  return true;
}

bool isAsListed(const SourceFile& file) {
  SourceFile now = file;
  return askFileSystem(now) && now.size == file.size && now.modified == file.modified;
}

fs::path folderOf(const fs::path& source) {
  std::error_code ignored;
  return fs::is_directory(source, ignored) ? source : source.parent_path();
}

}  // namespace

std::vector<SourceFile> listSourceFiles(const fs::path& path, const SourceOptions& options) {
  std::vector<SourceFile> files;
  std::set<fs::path> known;
  for (const std::string& start : {path.string(), options.mask.string(), options.rig}) {
    if (start.empty()) continue;
    for (const std::string& name : inputFiles(start)) {
      std::error_code error;
      if (!fs::is_regular_file(name, error)) continue;
      SourceFile file = {fs::absolute(name).lexically_normal(), {}};
      if (known.insert(file.path).second && askFileSystem(file)) files.push_back(file);
    }
  }
  return files;
}

Status addHashes(const fs::path& path, const std::vector<SourceReference>& references,
                 std::vector<SourceFile>& files, const JobContext& context) {
  for (const SourceReference& reference : references) {
    const fs::path named = fs::absolute(folderOf(path) / reference.file).lexically_normal();
    for (SourceFile& file : files) {
      if (file.path == named) file.hash = reference.hash;
    }
  }
  for (SourceFile& file : files) {
    if (!file.hash.empty() || !isAsListed(file)) continue;
    CUTIS_TRY(hash, hashFile(file.path, context));
    if (isAsListed(file)) file.hash = hash;
  }
  return {};
}

Result<std::vector<fs::path>> changedFiles(std::vector<SourceFile>& files,
                                           const JobContext& context) {
  std::vector<fs::path> changed;
  for (SourceFile& file : files) {
    SourceFile now = file;
    if (!askFileSystem(now)) continue;  // between the steps of a program that replaces it
    if (now.size == file.size && now.modified == file.modified) continue;
    CUTIS_TRY(hash, hashFile(file.path, context));
    if (hash != file.hash) changed.push_back(file.path);
    file = now;
  }
  return changed;
}

std::vector<fs::path> missingFiles(const std::vector<SourceFile>& files) {
  std::vector<fs::path> missing;
  std::error_code ignored;
  for (const SourceFile& file : files) {
    if (!fs::exists(file.path, ignored)) missing.push_back(file.path);
  }
  return missing;
}

fs::path firstMissing(const std::vector<SourceFile>& files) {
  const std::vector<fs::path> missing = missingFiles(files);
  return missing.empty() ? fs::path() : missing.front();
}

}  // namespace cutis
