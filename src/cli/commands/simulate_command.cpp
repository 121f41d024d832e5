// simulate: photographs of known skin.

#include "core/simulate/photograph.h"
#include "core/simulate/skin_mask.h"
#include "core/simulate/skin_patch.h"
#include "src/cli/command.h"
#include "src/cli/commands/maps_input.h"
#include "src/cli/options/add_option.h"
#include "src/cli/options/option_values.h"
#include "src/cli/output_check.h"
#include "src/files/profiles/profile_file.h"
#include "src/files/recipe_file.h"
#include "src/files/rig_file.h"
#include "src/images/capture/capture_file.h"

namespace cutis {
namespace {

constexpr char kDefaultRig[] = "monitor";
constexpr char kGroundTruthFile[] = "maps.exr";
constexpr double kMostNoise = 1.0;
// Below this the steps of a half would be part of the noise.
constexpr double kLeastNoiseInHalf = 0.002;

struct SimulateCommand {
  std::string maps;
  std::string patch;
  std::string recipe;
  std::string rig;
  std::string noise;
  std::string seed;
  std::string profile;
  std::string output;
  bool overwrite = false;
};

struct Subject {
  std::shared_ptr<const SkinModel> model;
  ChromophoreMaps maps;
  std::uint64_t seed = 1;
  std::optional<MapsFile> groundTruth;  // written beside the photographs
  ImageMetadata metadata;
};

Result<Subject> patchOf(const SimulateCommand& command, const Rig& rig, Session& session) {
  CUTIS_TRY(size, pixelSize("--patch", command.patch, kLargestPatch));
  CUTIS_TRY(recipe,
            loadRecipe(command.recipe.empty() ? kSampleRecipe : command.recipe, "--recipe"));
  const std::string profile = command.profile.empty() ? kDefaultProfile : command.profile;
  CUTIS_TRY(model, session.engine.model(profile, "--profile"));
  CUTIS_TRY(profileJson, profileText(profile, "--profile"));
  Subject subject;
  subject.model = model;
  subject.seed = recipe.seed;
  if (!command.seed.empty()) {
    CUTIS_TRY(seed, seedNumber("--seed", command.seed));
    subject.seed = seed;
  }
  CUTIS_TRY(skin,
            simulateSkin(recipe.skin, size.width, size.height, subject.seed, model->profile().axes,
                         session.store, session.context.child(0.0, 0.3, "painting skin")));
  subject.maps = skin.maps;
  MapsFile truth;
  truth.maps = skin.maps;
  truth.attributes.profileName = model->profile().name;
  truth.attributes.profileJson = profileJson;
  truth.attributes.rigName = rig.name;
  truth.attributes.method = "ground truth";
  subject.groundTruth = std::move(truth);
  return subject;
}

Result<Subject> mapsOf(const SimulateCommand& command, Session& session) {
  if (!command.recipe.empty()) {
    return usageError("--recipe", "a recipe is for --patch; leave it out with maps");
  }
  Subject subject;
  if (!command.seed.empty()) {
    CUTIS_TRY(seed, seedNumber("--seed", command.seed));
    subject.seed = seed;
  }
  CUTIS_TRY(opened, openMaps(command.maps, command.profile, session,
                             session.context.child(0.0, 0.3, "reading")));
  subject.model = opened.model;
  subject.maps = opened.file.maps;
  subject.metadata = opened.file.metadata;
  return subject;
}

Result<double> noiseOf(const SimulateCommand& command, const Rig& rig) {
  if (command.noise.empty()) return rig.noise.proportional;
  return realNumber("--noise", command.noise, 0.0, kMostNoise);
}

SampleType sampleTypeFor(double noise) {
  return noise < kLeastNoiseInHalf ? SampleType::float32 : SampleType::half;
}

// Nothing that is written into the folder is a file that is read.
Status checkFilesOf(const SimulateCommand& command, const Rig& rig, double noise) {
  const std::vector<std::string> inputs = {command.maps, command.recipe, command.rig,
                                           command.profile};
  CUTIS_CHECK(checkNotInput(command.output, inputs));
  std::vector<std::string> names = captureFileNames(rig, sampleTypeFor(noise));
  if (command.maps.empty()) names.emplace_back(kGroundTruthFile);
  for (const std::string& name : names) {
    CUTIS_CHECK(checkNotInput((std::filesystem::path(command.output) / name).string(), inputs));
  }
  return {};
}

Status runSimulateCommand(const SimulateCommand& command, Session& session) {
  if (command.maps.empty() == command.patch.empty()) {
    return usageError("simulate", "name maps or give --patch WIDTHxHEIGHT, but not both");
  }
  CUTIS_CHECK(checkCaptureFolder(command.output, command.overwrite));
  CUTIS_TRY(rig, loadRig(command.rig.empty() ? kDefaultRig : command.rig, {}, "--rig",
                         session.context.notice));
  CUTIS_TRY(noise, noiseOf(command, rig));
  CUTIS_CHECK(checkFilesOf(command, rig, noise));
  CUTIS_TRY(subject,
            command.maps.empty() ? patchOf(command, rig, session) : mapsOf(command, session));
  const JobContext& context = session.context;
  CUTIS_TRY(photographs, photograph(subject.maps, *subject.model, rig, noise, subject.seed,
                                    context.child(0.3, 0.6, "photographing")));
  CaptureWriteOptions options;
  options.rig = command.rig.empty() ? kDefaultRig : command.rig;
  options.sampleType = sampleTypeFor(noise);
  CUTIS_TRY(mask, skinMask(photographs, context.child(0.6, 0.62)));
  options.mask = mask;
  options.metadata = subject.metadata;
  const JobContext writing = context.child(0.62, 1.0, "writing");
  options.extra = [&](const std::filesystem::path& folder) -> Status {
    if (!subject.groundTruth) return {};
    return writeMaps(folder / kGroundTruthFile, *subject.groundTruth, writing.child(0.9, 1.0));
  };
  return writeCapture(command.output, photographs, options, writing.child(0.0, 0.9));
}

}  // namespace

void addSimulateCommand(CLI::App& app, Invocation& invocation) {
  const auto options = std::make_shared<SimulateCommand>();
  CLI::App& command = addCommand(app, invocation, "simulate",
                                 "Photographs of known skin through a rig, as a capture", options,
                                 runSimulateCommand);
  addOption(command, "MAPS", options->maps, "", "Maps of the skin to photograph");
  addOption(
      command, "--patch", options->patch, "WxH",
      "Instead of maps a procedural patch of this many pixels, up to 8192 a side; its true maps "
      "are written as maps.exr beside the photographs");
  addOption(command, "--recipe", options->recipe, "NAME|FILE",
            "What the patch looks like: sample or a JSON file (default: sample)");
  addOption(command, "--rig", options->rig, "NAME|FILE",
            "Camera and lights: a built-in name or a JSON file (default: monitor)");
  addOption(
      command, "--noise", options->noise, "PROP",
      "Proportional standard deviation of a channel, from 0 to 1 (default: the rig's, 0.005 for "
      "the built-in ones); below 0.002 the files are float, else half");
  addOption(command, "--seed", options->seed, "N",
            "Another number gives other noise and another patch (default: 1, or the recipe's)");
  addOption(command, "--profile", options->profile, "NAME|FILE",
            std::string("Skin model: a built-in name or a JSON file (default: ") + kDefaultProfile +
                "; maps carry their own)");
  addOption(command, "-o,--output", options->output, "FOLDER", "Folder of the capture to write")
      ->required();
  command.add_flag("--overwrite", options->overwrite,
                   "Replace the photographs of a capture that stands in the folder");
}

}  // namespace cutis
