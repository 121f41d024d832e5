// apply: a texture or capture to its edited albedo.

#include <algorithm>
#include <optional>

#include "core/base/echoed_text.h"
#include "src/app/export/export.h"
#include "src/app/project/manifest.h"
#include "src/cli/command.h"
#include "src/cli/commands/fit_source.h"
#include "src/cli/commands/maps_input.h"
#include "src/cli/commands/project_input.h"
#include "src/cli/options/edit_options.h"
#include "src/cli/options/option_values.h"
#include "src/images/capture/capture_file.h"
#include "src/images/codec/image_formats.h"
#include "src/images/image_file.h"

namespace cutis {
namespace {

struct ApplyCommand {
  std::vector<std::string> sources;
  std::string output;
  std::string maps;
  std::string colorSpace;
  std::string bitDepth;
  bool pure = false;
  EditOptions edit;
  FitCommandOptions fit;
};

Status checkSources(const ApplyCommand& command) {
  if (command.sources.size() > 1) {
    return usageError(command.sources[1], "this version takes one source at a time; apply to one");
  }
  if (isProjectFile(command.sources.front())) {
    const std::string given = command.maps.empty() ? firstGiven(command.fit) : "--maps";
    if (given.empty()) return {};
    return usageError(given,
                      "a project says itself how its source is read and fitted; leave this "
                      "out");
  }
  FitCommandOptions fitting = command.fit;
  fitting.layer.clear();  // chosen of the source, whoever fitted it
  const std::string given = firstGiven(fitting);
  if (!command.maps.empty() && !given.empty() && given != "--profile") {
    return usageError(given, "with --maps nothing is fitted; leave this out");
  }
  return {};
}

// Maps that were made of other pictures still fit if they are of the same size.
void compareSources(const Source& source, const MapsFile& maps, const ApplyCommand& command,
                    const JobContext& context) {
  const auto isKnown = [&](const SourceReference& reference) {
    return std::any_of(maps.attributes.sources.begin(), maps.attributes.sources.end(),
                       [&](const SourceReference& known) { return known.hash == reference.hash; });
  };
  if (maps.attributes.sources.empty()) return;
  if (std::all_of(source.references.begin(), source.references.end(), isKnown)) return;
  context.say(command.maps + " was made from another picture than " + command.sources.front() +
              " is now");
}

// The colour space that was chosen when the maps were fitted; empty if the file itself says it or
// if the name means nothing here.
Result<std::string> choiceOfMaps(const std::string& path, const std::string& space,
                                 const JobContext& context) {
  CUTIS_TRY(header, readImageHeader(path, context));
  const auto decided = decideColors(header.colors, {}, path);
  const bool agrees = decided && decided.value().followed.space.name == space;
  if (agrees || space.empty() || header.colors.isConverted) return std::string();
  if (namedColorSpace(space, path)) return space;
  context.say(path + ": the maps were made of it when its colours were " + space +
              "; they are read as the file says now");
  return std::string();
}

Result<EditedAlbedo> openWithMaps(const ApplyCommand& command, const Session& session,
                                  const JobContext& context) {
  CUTIS_TRY(opened, openMaps(command.maps, command.fit.profile, session, context.child(0.0, 0.5)));
  const std::string& path = command.sources.front();
  SourceOptions options;
  options.layer = command.fit.layer;
  if (!looksLikeCapture(path)) {
    CUTIS_TRY(choice, choiceOfMaps(path, opened.file.attributes.sourceColorSpace, session.context));
    options.colorSpace = choice;
  } else if (opened.file.attributes.specularShare > 0.0) {
    options.surface =
        measurementGeometry(SpecularPart::included, opened.model->profile().refractiveIndex,
                            opened.file.attributes.specularShare);
  }
  CUTIS_TRY(source,
            openSource(path, options, *opened.model, session.store, context.child(0.5, 1.0)));
  const ChromophoreMaps& maps = opened.file.maps;
  const auto sizeText = [](int width, int height) {
    return std::to_string(width) + " × " + std::to_string(height);
  };
  const Measurements& pixels = source.measurements;
  if (pixels.width() != maps.width() || pixels.height() != maps.height()) {
    return inputError(command.maps, "the maps are " + sizeText(maps.width(), maps.height()) +
                                        " but " + inQuotes(path) + " is " +
                                        sizeText(pixels.width(), pixels.height()) +
                                        "; name the maps of this source");
  }
  compareSources(source, opened.file, command, context);
  source.measurements.exposure = opened.file.attributes.exposure;
  return EditedAlbedo{{opened.model, maps, {}}, std::make_shared<const Source>(std::move(source))};
}

Result<EditedAlbedo> fitNow(const ApplyCommand& command, const FitRequest& request,
                            const Session& session) {
  CUTIS_TRY(result, openAndFit(command.sources.front(), request, session, 0.6));
  const FittedSource& fitted = result.fitted;
  return EditedAlbedo{{fitted.model, fitted.planes.maps, {}}, fitted.source};
}

Result<EditedAlbedo> open(const ApplyCommand& command, const FitRequest& request,
                          const Session& session) {
  const JobContext context = session.context.child(0.0, 0.6, "reading");
  const std::string& source = command.sources.front();
  if (isProjectFile(source)) return openProjectAlbedo(source, session, context);
  return command.maps.empty() ? fitNow(command, request, session)
                              : openWithMaps(command, session, context);
}

ExportTarget appliedTargetOf(const ApplyCommand& command, const FitRequest& request,
                             std::optional<SampleType> sampleType) {
  ExportTarget target = {.path = command.output,
                         .sampleType = sampleType,
                         .colorSpace = command.colorSpace,
                         .inputs = filesRead(request),
                         .sources = {command.sources.front()}};
  target.inputs.push_back(command.maps);
  target.inputs.push_back(command.edit.mask);
  target.inputs.push_back(command.edit.preset);
  return target;
}

Status runApplyCommand(const ApplyCommand& command, Session& session) {
  CUTIS_CHECK(checkSources(command));
  CUTIS_TRY(edits, parseEditOptions(command.edit, session.context.notice));
  CUTIS_TRY(request, parseFitOptions(command.fit));
  CUTIS_TRY(sampleType, bitDepth("--bit-depth", command.bitDepth));
  const ExportTarget target = appliedTargetOf(command, request, sampleType);
  CUTIS_CHECK(checkPictureTarget(target));
  const JobContext& context = session.context;
  CUTIS_TRY(albedo, open(command, request, session));
  CUTIS_CHECK(loadEditMask(command.edit,
                           maskedPicture(*albedo.source, "'" + command.sources.front() + "'"),
                           session.store, context.child(0.6, 0.62), edits));
  EditStack& all = albedo.skin.edits;  // those of a project come first
  all.insert(all.end(), edits.begin(), edits.end());
  albedo.pure = command.pure;
  return exportTo(target, albedo, session.engine, session.store, context.child(0.62, 1.0));
}

}  // namespace

void addApplyCommand(CLI::App& app, Invocation& invocation) {
  const auto options = std::make_shared<ApplyCommand>();
  CLI::App& command = addCommand(
      app, invocation, "apply",
      "Edit a texture or a capture and write the edited albedo: the source times what the edit "
      "changes in the model, so that hair, pores and make-up survive",
      options, runApplyCommand);
  command
      .add_option(
          "SOURCE", options->sources,
          "Image, folder or capture.json of a capture, or project (.cutis), whose edits come "
          "before those of the options")
      ->required()
      ->type_name("");
  command.add_option("-o,--output", options->output, "Image to write: " + writtenExtensions())
      ->required()
      ->type_name("IMAGE");
  command
      .add_option("--maps", options->maps,
                  "Maps of the source, as written by fit (default: fit now)")
      ->type_name("MAPS");
  command.add_flag("--pure", options->pure,
                   "Write the edited model alone where there is an estimate");
  command
      .add_option("--colorspace", options->colorSpace,
                  "Colour space to write (default: the source's; of a capture Linear Rec.709 in "
                  "floats, sRGB in integers)")
      ->type_name("NAME");
  command
      .add_option("--bit-depth", options->bitDepth,
                  "Samples to write: half or float in OpenEXR, 8, 16 or float in TIFF, 8 or 16 in "
                  "PNG, 8 in JPEG (default: the source's, else the next that holds more)")
      ->type_name("half|float|8|16");
  addEditOptions(command, options->edit);
  addFitOptions(command, options->fit);
}

}  // namespace cutis
