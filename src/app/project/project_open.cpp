#include "src/app/project/project_open.h"

#include <algorithm>
#include <utility>

#include "src/app/open/image_search.h"
#include "src/app/open/sample_source.h"
#include "src/files/profiles/profile_file.h"
#include "src/images/codec/source_file.h"
#include "src/images/maps/maps_file.h"

namespace cutis {
namespace {

namespace fs = std::filesystem;

// Where reading the source ends, as a share of the progress.
constexpr double kSourceRead = 0.7;

// Why the maps of a project do not hold; empty where they do, in `maps`.
class MapsKeeper {
 public:
  MapsKeeper(const Project& project, const std::shared_ptr<TileStore>& store,
             const JobContext& context)
      : project_(project), store_(store), context_(context) {}

  Result<std::string> read(const SkinModel& model, const Source& source, MapsFile& maps) const {
    const std::string name = project_.maps.filename().string();
    const auto hash = hashFile(project_.maps, context_);
    if (hash.cancelled()) return Cancelled{};
    if (!hash || hash.value() != project_.maps.stem().string())
      return "the project's maps " + name + " are missing or damaged";
    const auto read = readMaps(project_.maps, PixelFormat::float32, store_, context_);
    if (read.cancelled()) return Cancelled{};
    if (!read) return "the project's maps cannot be read (" + read.error().message + ")";
    CUTIS_TRY(profile, profileText(project_.fit.profile, {}));
    if (read.value().attributes.profileJson != profile)
      return "the profile " + project_.fit.profile +
             " is not what the project's maps were fitted "
             "with";
    const ChromophoreMaps& fitted = read.value().maps;
    const Measurements& pixels = source.measurements;
    const bool fits = fitted.width() == pixels.width() && fitted.height() == pixels.height() &&
                      checkCoefficients(fitted, model.profile(), name);
    if (!fits) return "the project's maps " + name + " are of another picture";
    maps = read.value();
    return std::string();
  }

 private:
  const Project& project_;
  const std::shared_ptr<TileStore>& store_;
  JobContext context_;
};

Result<Source> readSource(const ProjectSource& source, const SkinModel& model, Engine& engine,
                          const std::shared_ptr<TileStore>& store, const JobContext& context,
                          const PreviewSink* preview) {
  if (source.kind == SourceKind::sample) return openSampleFor(model, engine, store, context);
  return openSource(source.path, source.options, model, store, context, preview);
}

std::string titleOf(const Project& project) {
  return project.source.path.empty() ? "the sample" : project.source.path.filename().string();
}

fs::path movedAlong(const fs::path& file, const fs::path& missing, const fs::path& found) {
  const fs::path moved =
      (found.parent_path() / file.lexically_proximate(missing.parent_path())).lexically_normal();
  std::error_code ignored;
  return !fs::exists(file, ignored) && fs::exists(moved, ignored) ? moved : file;
}

}  // namespace

bool checkUnchanged(const std::vector<SourceFile>& saved, const std::vector<SourceFile>& now,
                    const JobContext& context) {
  for (const auto& [files, others] : {std::pair(&now, &saved), std::pair(&saved, &now)}) {
    for (const SourceFile& file : *files) {
      const bool isKnown =
          std::any_of(others->begin(), others->end(), [&](const SourceFile& other) {
            return other.path == file.path && other.hash == file.hash && !file.hash.empty();
          });
      if (isKnown) continue;
      context.say(file.path.string() +
                  ": this has changed since the project was saved; it is fitted again, and the "
                  "edits are kept");
      return false;
    }
  }
  return true;
}

Result<OpenedSource> openSourceOf(ProjectSource& source, const FitChoice& fit, Engine& engine,
                                  const std::shared_ptr<TileStore>& store,
                                  const JobContext& context, const PreviewSink* preview) {
  CUTIS_TRY(model, engine.model(fit.profile, {}));
  source.options.surface = surfaceOf(fit, model->profile());
  source.files.clear();
  if (source.kind != SourceKind::sample)
    source.files = listSourceFiles(source.path, source.options);
  CUTIS_TRY(read, readSource(source, *model, engine, store, context, preview));
  CUTIS_CHECK(addHashes(source.path, read.references, source.files, context.child(1.0, 1.0)));
  const auto opened = std::make_shared<const Source>(std::move(read));
  return OpenedSource{model, atChosenExposure(opened, fit), {}};
}

fs::path unusedMaskBeside(const ProjectSource& source) {
  if (source.path.empty() || !source.options.mask.empty() || isNamedMask(source.path)) return {};
  // A capture may name its own.
  const bool isMasked = std::any_of(source.files.begin(), source.files.end(),
                                    [](const SourceFile& file) { return isNamedMask(file.path); });
  if (isMasked) return {};
  std::error_code ignored;
  return maskBeside(fs::is_directory(source.path, ignored) ? source.path / "capture.json"
                                                           : source.path);
}

Result<OpenedSource> openProjectSource(Project& project, Engine& engine,
                                       const std::shared_ptr<TileStore>& store,
                                       const JobContext& context) {
  const std::vector<SourceFile> saved = project.source.files;
  CUTIS_TRY(opened, openSourceOf(project.source, project.fit, engine, store,
                                 context.child(0.0, kSourceRead, "reading")));
  CUTIS_CHECK(checkFitChoice(project.fit, *opened.source));
  if (checkUnchanged(saved, project.source.files, context) && !project.maps.empty()) {
    MapsFile maps;
    const MapsKeeper keeper(project, store, context.child(kSourceRead, 1.0, "maps"));
    CUTIS_TRY(objection, keeper.read(*opened.model, *opened.source, maps));
    if (objection.empty()) {
      Source exposed = *opened.source;  // planes are handles
      exposed.measurements.exposure = maps.attributes.exposure;
      opened.source = std::make_shared<const Source>(std::move(exposed));
      opened.maps = maps.maps;
    } else {
      context.say(titleOf(project) + ": " + objection + "; it is fitted again");
    }
  }
  if (!opened.maps) project.maps.clear();
  return std::move(opened);
}

fs::path missingFile(const ProjectSource& source) {
  std::vector<SourceFile> files = source.files;
  if (!source.path.empty()) files.push_back({source.path, {}});
  return firstMissing(files);
}

Error missingSourceError(const fs::path& project, const fs::path& file) {
  return inputError(project.string(), "its source " + file.string() +
                                          " is not there; put it back, or open the project in the "
                                          "window, which asks where it is now");
}

Project relinked(const Project& project, const fs::path& missing, const fs::path& found) {
  Project moved = project;
  const auto move = [&](const fs::path& file) {
    return file == missing ? found : movedAlong(file, missing, found);
  };
  ProjectSource& source = moved.source;
  std::error_code ignored;
  const bool wasFolder = source.kind == SourceKind::capture &&
                         missing.parent_path() == source.path && !fs::exists(source.path, ignored);
  source.path = wasFolder ? found.parent_path() : move(source.path);
  if (!source.options.mask.empty()) source.options.mask = move(source.options.mask);
  if (fs::path(source.options.rig).is_absolute())
    source.options.rig = move(source.options.rig).string();
  for (SourceFile& file : source.files)
    file.path = move(file.path);
  return moved;
}

std::string savedHash(const Project& project, const fs::path& file) {
  for (const SourceFile& known : project.source.files) {
    if (known.path == file) return known.hash;
  }
  return {};
}

}  // namespace cutis
