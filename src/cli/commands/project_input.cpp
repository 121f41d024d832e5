#include "src/cli/commands/project_input.h"

#include "src/app/open/source_fit.h"
#include "src/app/project/manifest.h"
#include "src/app/project/project_open.h"

namespace cutis {
namespace {

// Where reading ends, as a share of the progress.
constexpr double kProjectRead = 0.3;

// What nobody can choose is an error in the project's file, where it was chosen.
template <typename T>
Result<T> inProject(Result<T> result, const std::string& path) {
  if (!result.failed() || result.error().kind != ErrorKind::usage) return result;
  return inputError(path + ": fit", result.error().text());
}

}  // namespace

Result<EditedAlbedo> openProjectAlbedo(const std::string& path, const Session& session,
                                       const JobContext& context) {
  CUTIS_TRY(project, readProject(path, context.notice));
  const std::filesystem::path missing = missingFile(project.source);
  if (!missing.empty()) return missingSourceError(path, missing);
  if (project.source.kind == SourceKind::maps) {
    return inputError(path,
                      "this project is of maps alone, which hold no albedo; apply to a project of "
                      "the photographs they were fitted to");
  }
  CUTIS_TRY(opened, inProject(openProjectSource(project, session.engine, session.store,
                                                context.child(0.0, kProjectRead, "reading")),
                              path));
  EditedAlbedo albedo;
  albedo.source = opened.source;
  if (opened.maps) {
    albedo.skin = {opened.model, *opened.maps, project.edits};
    return albedo;
  }
  CUTIS_TRY(options, inProject(fitOptions(project.fit, opened.model->profile()), path));
  CUTIS_TRY(fitted, fitSource(opened.model, opened.source, {options, !project.fit.exposure},
                              session.engine, session.store, context.child(kProjectRead, 1.0)));
  for (const FitRemark& remark : fitted.remarks)
    context.say(path + ": " + remark.sentence);
  albedo.source = fitted.source;
  albedo.skin = {fitted.model, fitted.planes.maps, project.edits};
  return albedo;
}

}  // namespace cutis
