#include "src/app/project/project_save.h"

#include <fstream>
#include <optional>
#include <string>
#include <utility>

#include "src/app/project/manifest.h"
#include "src/files/io/atomic_write.h"
#include "src/files/system/platform.h"
#include "src/files/system/temporary_path.h"
#include "src/images/codec/source_file.h"

namespace cutis {

namespace fs = std::filesystem;

namespace {

constexpr char kMapsExtension[] = ".exr";

// What names temporaries in the data folder.
constexpr char kMapsName[] = "maps.exr";
constexpr char kChangeName[] = "change";

// The maps that a manifest names in its own folder of data; empty if it is no manifest or names
// none there.
fs::path ownMaps(const fs::path& manifest) {
  std::error_code ignored;
  if (!fs::is_regular_file(manifest, ignored)) return {};
  const auto project = readProject(manifest, {});
  if (!project || project.value().maps.parent_path() != dataFolder(manifest)) return {};
  return project.value().maps;
}

// The names of files of maps that a save brings in or takes away, written down while it is under
// way: by these what a kill leaves behind is told from the maps of others.
class ChangeNote {
 public:
  ChangeNote(const fs::path& folder, const fs::path& fresh, const fs::path& earlier)
      : path_(temporaryBeside(folder / kChangeName)) {
    std::ofstream note(path_);
    for (const fs::path& file : {fresh, earlier}) {
      if (!file.empty()) note << file.filename().string() << '\n';
    }
  }
  ~ChangeNote() {
    std::error_code ignored;
    fs::remove(path_, ignored);
  }
  ChangeNote(const ChangeNote&) = delete;
  ChangeNote& operator=(const ChangeNote&) = delete;

 private:
  fs::path path_;
};

Error cannotBeSaved(const fs::path& folder, const std::error_code& error) {
  return resourceError(folder.string(), "the project's data cannot be put there (" +
                                            error.message() + "); save to another folder");
}

// Writes or copies the maps to a temporary and returns the name that their content gives them.
Result<fs::path> writeFreshMaps(const fs::path& temporary, const Project& project,
                                const MapsFile* maps, const JobContext& context) {
  const fs::path folder = temporary.parent_path();
  std::error_code error;
  fs::create_directories(folder, error);
  if (error) return cannotBeSaved(folder, error);
  if (maps != nullptr) {
    CUTIS_CHECK(writeMaps(temporary, *maps, context));
  } else {
    fs::copy_file(project.maps, temporary, error);
    if (error || !flushToDisk(temporary)) return cannotBeSaved(folder, error);
  }
  CUTIS_TRY(hash, hashFile(temporary, context));
  return folder / (hash + kMapsExtension);
}

Status putInPlace(const fs::path& temporary, const fs::path& file) {
  std::error_code error;
  fs::rename(temporary, file, error);
  if (error) return cannotBeSaved(file.parent_path(), error);
  return {};
}

void removeWith(const fs::path& file) {
  std::error_code ignored;
  if (!file.empty()) fs::remove(file, ignored);
}

}  // namespace

fs::path dataFolder(const fs::path& project) {
  return fs::absolute(project).lexically_normal().string() + ".data";
}

Result<Project> saveProject(const fs::path& path, Project project, const MapsFile* maps,
                            const JobContext& context) {
  CUTIS_CHECK(checkWritable(path));
  removeLeftovers(path);
  const fs::path folder = dataFolder(path);
  const fs::path earlier = ownMaps(path);
  const TemporaryPath temporary(temporaryBeside(folder / kMapsName));
  const bool isNew =
      maps != nullptr || (!project.maps.empty() && project.maps.parent_path() != folder);
  if (isNew) {
    CUTIS_TRY(file, writeFreshMaps(temporary.path(), project, maps, context.child(0.0, 0.9)));
    project.maps = file;
  }
  if (context.stopRequested()) return Cancelled{};
  {
    std::optional<ChangeNote> note;
    if (project.maps != earlier) note.emplace(folder, project.maps, earlier);
    if (isNew) CUTIS_CHECK(putInPlace(temporary.path(), project.maps));
    const fs::path manifest = fs::absolute(path).lexically_normal();
    const Status saved = writeTextAtomically(path, projectText(project, manifest.parent_path()));
    const fs::path& unused = saved ? earlier : project.maps;
    if (project.maps != earlier && (saved || isNew)) removeWith(unused);
    if (!saved) return saved.failure();
  }
  std::error_code ignored;
  fs::remove(folder, ignored);  // where nothing is left in it
  return project;
}

void removeLeftovers(const fs::path& project) {
  const fs::path folder = dataFolder(project);
  std::error_code ignored;
  for (const fs::path& partial : abandonedBeside(project))
    fs::remove(partial, ignored);
  const fs::path named = ownMaps(project);
  for (const fs::path& note : abandonedBeside(folder / kChangeName)) {
    std::ifstream stream(note);
    for (std::string name; std::getline(stream, name);) {
      // Names of files in this folder alone.
      if (fs::path(name).has_parent_path() || folder / name == named) continue;
      if (fs::path(name).extension() == kMapsExtension) removeWith(folder / name);
    }
    fs::remove(note, ignored);
  }
  for (const fs::path& partial : abandonedIn(folder))
    fs::remove(partial, ignored);
  fs::remove(folder, ignored);
}

}  // namespace cutis
