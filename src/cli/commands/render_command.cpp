// render: maps to a picture of the skin under a light, or of a band.

#include <optional>

#include "core/base/echoed_text.h"
#include "src/app/export/export.h"
#include "src/cli/command.h"
#include "src/cli/commands/maps_input.h"
#include "src/images/codec/image_formats.h"

namespace cutis {
namespace {

struct RenderCommand {
  std::string maps;
  std::string output;
  std::string profile;
  std::string light;
  std::string observer;
  std::string band;
  std::string colorSpace;
  std::string adaptation;
  std::string bitDepth;
};

Result<ChromaticAdaptation> adaptationNamed(const std::string& name) {
  if (name.empty() || name == "none") return ChromaticAdaptation::none;
  if (name == "bradford") return ChromaticAdaptation::bradford;
  if (name == "cat16") return ChromaticAdaptation::cat16;
  return usageError("--adapt", inQuotes(name) + " is unknown; choose none, bradford or cat16");
}

Status refuse(const std::string& option, const std::string& value, const char* reason) {
  return value.empty() ? Status() : usageError(option, reason);
}

Result<PictureRequest> bandRequest(const RenderCommand& command) {
  constexpr char reason[] = "a band is seen in flat light by a flat sensor; leave this out";
  CUTIS_CHECK(refuse("--light", command.light, reason));
  CUTIS_CHECK(refuse("--observer", command.observer, reason));
  CUTIS_CHECK(refuse("--adapt", command.adaptation, reason));
  CUTIS_CHECK(refuse("--colorspace", command.colorSpace,
                     "a band is one channel without colour; leave this out"));
  PictureRequest request;
  CUTIS_TRY(band, parseBand(command.band, "--band"));
  request.band = band;
  return request;
}

// Reads the light and the observer.
Result<PictureRows> pictureOf(const RenderCommand& command, const Session& session) {
  if (!command.band.empty()) {
    CUTIS_TRY(band, bandRequest(command));
    return pictureRows(band, {});
  }
  PictureRequest request;
  if (!command.light.empty()) request.light = command.light;
  if (!command.observer.empty()) request.observer = command.observer;
  CUTIS_TRY(adaptation, adaptationNamed(command.adaptation));
  request.adaptation = adaptation;
  CUTIS_TRY(picture, pictureRows(request, {"--light", "--observer"}, session.context.notice));
  if (picture.isColor) return picture;
  constexpr char reason[] = "a camera's own channels have no colour space; leave this out";
  CUTIS_CHECK(refuse("--colorspace", command.colorSpace, reason));
  CUTIS_CHECK(refuse("--adapt", command.adaptation, reason));
  return picture;
}

Status runRenderCommand(const RenderCommand& command, Session& session) {
  CUTIS_TRY(picture, pictureOf(command, session));
  ExportTarget target = {.path = command.output,
                         .colorSpace = command.colorSpace,
                         .inputs = {command.profile, command.light, command.observer},
                         .sources = {command.maps}};
  CUTIS_TRY(type, bitDepth("--bit-depth", command.bitDepth));
  target.sampleType = type;
  CUTIS_CHECK(checkPictureTarget(target));
  const JobContext& context = session.context;
  CUTIS_TRY(opened,
            openMaps(command.maps, command.profile, session, context.child(0.0, 0.35, "reading")));
  const SkinPicture what = {
      {opened.model, opened.file.maps, {}}, std::move(picture), opened.file.metadata};
  return exportTo(target, what, session.engine, session.store, context.child(0.35, 1.0));
}

}  // namespace

void addRenderCommand(CLI::App& app, Invocation& invocation) {
  const auto options = std::make_shared<RenderCommand>();
  CLI::App& command =
      addCommand(app, invocation, "render",
                 "Picture of maps under a light, or of a band; a perfect diffuser is 1", options,
                 runRenderCommand);
  const auto option = [&](const char* name, std::string& value, const char* type,
                          const char* text) {
    command.add_option(name, value, text)->type_name(type);
  };
  command.add_option("MAPS", options->maps, "Maps to render")->required()->type_name("");
  command.add_option("-o,--output", options->output, "Image to write: " + writtenExtensions())
      ->required()
      ->type_name("IMAGE");
  option("--light", options->light, "NAME|FILE",
         "Light: a built-in name, see 'cutis-cli info --system', or a CSV file (default: D65)");
  option("--observer", options->observer, "NAME|FILE",
         "Observer or camera: a built-in name or a CSV file (default: cie1931); a camera gives its "
         "own channels");
  option("--band", options->band, "uv|nir|A:B",
         "Instead of colour one channel, the mean reflectance from A to B nm; uv is 300:400, nir "
         "700:1000; linear in floats, with the sRGB curve in integers");
  option("--colorspace", options->colorSpace, "NAME",
         "Colour space to write (default: Linear Rec.709 in floats, sRGB in integers)");
  option("--adapt", options->adaptation, "none|bradford|cat16",
         "Chromatic adaptation from the light's white to D65 (default: none)");
  option("--bit-depth", options->bitDepth, "half|float|8|16",
         "Samples (default: half in EXR, 16 in TIFF, 8 in PNG and JPEG)");
  addMapsProfileOption(command, options->profile);
}

}  // namespace cutis
