// apply: a texture or capture to its edited albedo.

#include <algorithm>

#include "src/app/export/edited_source.h"
#include "src/cli/command.h"
#include "src/cli/commands/fit_source.h"
#include "src/cli/commands/maps_input.h"
#include "src/cli/commands/picture_output.h"
#include "src/cli/options/edit_options.h"
#include "src/cli/output_check.h"
#include "src/images/capture/capture_file.h"

namespace cutis {
namespace {

struct ApplyCommand {
  std::vector<std::string> sources;
  std::string output;
  std::string maps;
  std::string colorSpace;
  bool pure = false;
  EditArguments edit;
  FitArguments fit;
};

// What is edited and with what.
struct AppliedSubject {
  Source source;
  ChromophoreMaps maps;
  std::shared_ptr<const SkinModel> model;
  double exposure = 1.0;
};

Status checkSources(const ApplyCommand& command) {
  if (command.sources.size() > 1) {
    return usageError(command.sources[1],
                      "several sources are not in this version; apply to one at a time");
  }
  if (command.sources.front().ends_with(".cutis")) {
    return usageError(command.sources.front(), "projects are not in this version");
  }
  const std::string given = firstGiven(command.fit);
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

Result<AppliedSubject> openWithMaps(const ApplyCommand& command, const Session& session,
                                    const JobContext& context) {
  CUTIS_TRY(opened, openMaps(command.maps, command.fit.profile, session, context.child(0.0, 0.5)));
  const std::string& path = command.sources.front();
  SourceOptions options;
  if (!looksLikeCapture(path)) {
    options.colorSpace = opened.file.attributes.sourceColorSpace;
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
                                        " but '" + path + "' is " +
                                        sizeText(pixels.width(), pixels.height()) +
                                        "; name the maps of this source");
  }
  compareSources(source, opened.file, command, context);
  return AppliedSubject{std::move(source), maps, opened.model, opened.file.attributes.exposure};
}

Result<AppliedSubject> openAndFit(const ApplyCommand& command, const FitRequest& request,
                                  const Session& session) {
  CUTIS_TRY(fitted, fitSource(command.sources.front(), request, session, 0.6));
  const double exposure = fitted.source.exposure;
  return AppliedSubject{std::move(fitted.source), fitted.planes.maps, fitted.model, exposure};
}

struct OutputFormat {
  SampleType type = SampleType::half;
  std::string colorSpace;
};

// As the source unless the format cannot hold that, or another space is asked for.
Result<OutputFormat> outputFormat(const ApplyCommand& command, const Source& source,
                                  const JobContext& context) {
  CUTIS_TRY(types, writableSampleTypes(command.output));
  OutputFormat format = {types.front(), {}};
  if (source.image) {
    const SampleType own = source.image->sourceType;
    if (std::find(types.begin(), types.end(), own) != types.end()) format.type = own;
    if (isInteger(own) == isInteger(format.type)) format.colorSpace = source.colorSpace;
  }
  if (!command.colorSpace.empty() || format.colorSpace.empty()) {
    CUTIS_TRY(space, outputSpace(command.colorSpace, format.type));
    format.colorSpace = space;
  }
  if (source.image && source.image->sourceType != format.type) {
    context.say(command.output + ": the source's samples are " +
                sampleTypeName(source.image->sourceType) + ", this file's are " +
                sampleTypeName(format.type) + " in " + format.colorSpace);
  }
  return format;
}

Status checkOutput(const ApplyCommand& command, const FitRequest& request) {
  CUTIS_TRY(inputs, inputFiles(command.sources.front()));
  for (const std::string& file : filesRead(request))
    inputs.push_back(file);
  inputs.push_back(command.maps);
  inputs.push_back(command.edit.mask);
  CUTIS_CHECK(imageOutputType(command.output, "", inputs));
  CUTIS_CHECK(outputSpace(command.colorSpace, SampleType::half));
  return {};
}

Status runApplyCommand(const ApplyCommand& command, Session& session) {
  CUTIS_CHECK(checkSources(command));
  CUTIS_TRY(edit, parseEdit(command.edit));
  CUTIS_TRY(request, parseFitArguments(command.fit));
  CUTIS_CHECK(checkOutput(command, request));
  const JobContext& context = session.context;
  CUTIS_TRY(subject, command.maps.empty()
                         ? openAndFit(command, request, session)
                         : openWithMaps(command, session, context.child(0.0, 0.6, "reading")));
  CUTIS_TRY(format, outputFormat(command, subject.source, context));
  CUTIS_CHECK(loadEditMask(command.edit, subject.maps.width(), subject.maps.height(),
                           command.sources.front(), session.store, context.child(0.6, 0.62), edit));
  CUTIS_TRY(albedo,
            session.engine.picture(subject.model, PictureRequest(), "apply", subject.maps.free(),
                                   context.child(0.62, 0.65, "preparing")));
  CUTIS_TRY(content,
            editedTexture(subject.source, subject.maps, {edit}, subject.model->profile().axes,
                          *albedo, {format.colorSpace, command.pure, subject.exposure},
                          session.store, context.child(0.65, 0.8, "editing")));
  return writeImage(command.output, content, format.type, context.child(0.8, 1.0, "writing"));
}

}  // namespace

void addApplyCommand(CLI::App& app, Invocation& invocation) {
  const auto options = std::make_shared<ApplyCommand>();
  CLI::App& command = addCommand(
      app, invocation, "apply",
      "Edit a texture or a capture and write the edited albedo: the source times what the edit "
      "changes in the model, so that hair, pores and make-up survive",
      options, runApplyCommand);
  command.add_option("SOURCE", options->sources, "Image, or folder or capture.json of a capture")
      ->required()
      ->type_name("");
  command.add_option("-o,--output", options->output, "Image to write: .exr, .tif, .png or .jpg")
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
  addEditOptions(command, options->edit);
  addFitArguments(command, options->fit);
}

}  // namespace cutis
