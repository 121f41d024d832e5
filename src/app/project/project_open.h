#pragma once

// Opening a project: its source as it was opened then, with the fitted maps where they still hold.

#include <filesystem>
#include <memory>
#include <optional>
#include <string>

#include "core/base/job_context.h"
#include "core/base/result.h"
#include "core/skin/chromophore_maps.h"
#include "src/app/engine.h"
#include "src/app/project/project.h"

namespace cutis {

struct OpenedSource {
  std::shared_ptr<const SkinModel> model;
  std::shared_ptr<const Source> source;  // at the exposure of the maps
  std::optional<ChromophoreMaps> maps;   // none: to be fitted
};

// Reads a source, whose files then hold the hashes and times of now, for a fit as chosen.
// Precondition here and below: a source of another kind than maps. preview: as for openSource().
Result<OpenedSource> openSourceOf(ProjectSource& source, const FitChoice& fit, Engine& engine,
                                  const std::shared_ptr<TileStore>& store,
                                  const JobContext& context, const PreviewSink* preview = nullptr);

// A picture that by its name is the mask of a source which has none and is none itself; empty if
// there is no such picture beside it.
std::filesystem::path unusedMaskBeside(const ProjectSource& source);

// Reads the source of the project, whose files then hold the hashes and times of now. The maps are
// taken only where their bytes are those that were saved, no file of the source has changed and the
// profile is the same; else a notice says why they have to be fitted again.
Result<OpenedSource> openProjectSource(Project& project, Engine& engine,
                                       const std::shared_ptr<TileStore>& store,
                                       const JobContext& context);

// Notes it where one of these is another file than the project was saved with, or is new. Whether
// none is.
bool checkUnchanged(const std::vector<SourceFile>& saved, const std::vector<SourceFile>& now,
                    const JobContext& context);

// A project that cannot be opened as it is, because this file of its source is not there.
struct MissingSource {
  Project project;
  std::filesystem::path path;  // of the manifest; empty: an untitled one
  std::filesystem::path file;
};

// The first file of the source that is not there; empty if none is missing.
std::filesystem::path missingFile(const ProjectSource& source);

// A project without the file that it is missing, as an error for those who cannot ask for another
// place.
Error missingSourceError(const std::filesystem::path& project, const std::filesystem::path& file);

// The project with the file `found` for `missing`. What else is missing is looked for where it
// would be if the folder had moved as a whole.
Project relinked(const Project& project, const std::filesystem::path& missing,
                 const std::filesystem::path& found);

// The hash with which the project knows this file; empty if it does not.
std::string savedHash(const Project& project, const std::filesystem::path& file);

}  // namespace cutis
