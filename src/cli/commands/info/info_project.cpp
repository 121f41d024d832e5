#include "src/cli/commands/info/info_project.h"

#include <filesystem>

#include "core/base/number_text.h"
#include "core/base/word_list.h"
#include "src/app/fit_method.h"
#include "src/app/project/manifest.h"
#include "src/cli/commands/info/info_line.h"

namespace cutis {
namespace {

namespace fs = std::filesystem;

std::string fileText(const fs::path& file) {
  std::error_code ignored;
  return file.string() + (fs::exists(file, ignored) ? "" : " (missing)");
}

std::string sourceText(const ProjectSource& source, const std::optional<double>& exposure) {
  if (source.kind == SourceKind::sample) return line("source", "the embedded sample");
  std::string text = line("source", fileText(source.path));
  for (const SourceFile& file : source.files)
    text += line("file", fileText(file.path) + " (" + file.hash + ")");
  const SourceOptions& options = source.options;
  text += line("rig", options.rig) + line("lights", wordList(options.lights, ", ")) +
          line("mask", options.mask.string()) + line("layer", options.layer) +
          line("colour space", options.colorSpace);
  if (source.kind == SourceKind::image) {
    text +=
        line("exposure", exposure ? formatNumber(*exposure) : std::string("chosen by each fit"));
  }
  return text;
}

std::string editText(const Edit& edit) {
  std::vector<std::string> changed;
  for (const Parameter k : kParameters) {
    const ParameterEdit& parameter = edit.parameters[static_cast<std::size_t>(k)];
    if (parameter.isNeutral()) continue;
    const std::string name(parameterName(k));
    if (parameter.set) {
      changed.push_back(name + " = " + formatNumber(*parameter.set));
      continue;
    }
    if (parameter.scale != 1.0) changed.push_back(name + " × " + formatNumber(parameter.scale));
    if (parameter.add != 0.0) changed.push_back(name + " + " + formatNumber(parameter.add));
  }
  std::string text = changed.empty() ? "nothing" : wordList(changed, ", ");
  if (!edit.name.empty()) text = edit.name + ": " + text;
  if (edit.opacity < 1.0) text += ", opacity " + formatNumber(edit.opacity);
  return text + (edit.enabled ? "" : ", off");
}

}  // namespace

Result<std::string> describeProject(const std::string& path, const Session& session) {
  CUTIS_TRY(project, readProject(path, session.context.notice));
  std::string text = line("kind", "project") + sourceText(project.source, project.fit.exposure);
  text += line("profile", project.fit.profile);
  text += line("method",
               fitMethodName(project.fit.method) + (project.fit.shading ? ", with shading" : ""));
  if (project.source.kind != SourceKind::maps) {
    text += line("maps", project.maps.empty() ? "not fitted yet" : fileText(project.maps));
  }
  for (const Edit& edit : project.edits)
    text += line("edit", editText(edit));
  text += line("view", project.view.view) + line("light", project.view.light) +
          line("observer", project.view.observer);
  return text;
}

}  // namespace cutis
