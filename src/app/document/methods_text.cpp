#include "src/app/document/methods_text.h"

#include <filesystem>
#include <vector>

#include "core/base/number_text.h"
#include "core/rig/channel_extent.h"

namespace cutis {
namespace {

constexpr int kNoiseDigits = 3;
constexpr char kPaper[] =
    "X. Li, G. C. Guarnera, A. Lin, A. Ghosh: Practical Measurement and Neural Encoding of "
    "Hyperspectral Skin Reflectance. International Conference on 3D Vision (3DV), 2024.";

// Of a file its name, without the folders.
std::string shortNameOf(const std::string& nameOrPath) {
  return std::filesystem::path(nameOrPath).stem().string();
}

std::string listed(const std::vector<RigLight>& lights, const std::string& last) {
  std::string text;
  for (std::size_t i = 0; i < lights.size(); ++i) {
    if (i > 0) text += i + 1 == lights.size() ? last : ", ";
    text += lights[i].name;
  }
  return text;
}

std::string methodWords(FitMethod method) {
  switch (method) {
    case FitMethod::refined:
      return "maximum a posteriori estimates";
    case FitMethod::threeStage:
      return "the three-stage table search of the paper";
    case FitMethod::fullSearch:
      return "a full search of the table of skin";
    case FitMethod::network:
      break;
  }
  return "a neural network that was trained on the model";
}

NoiseModel noiseOf(const Rig& rig, const FitChoice& choice) {
  NoiseModel noise = rig.noise;
  if (!choice.noise) return noise;
  noise.read = choice.noise->front();
  noise.proportional = choice.noise->back();
  return noise;
}

std::string noiseSentence(const NoiseModel& noise) {
  if (noise.isExact()) return "No noise was assumed.";
  return "The standard deviation of a channel's noise was taken as the root of " +
         formatNumber(noise.read, kNoiseDigits) + "² + (" +
         formatNumber(noise.proportional, kNoiseDigits) +
         " · value)², where a perfect diffuser has the value 1.";
}

std::string priorSentence(const FitChoice& choice) {
  std::string text = choice.prior.empty()
                         ? "The prior of the parameters was that of the profile"
                         : "The prior of the parameters was " + shortNameOf(choice.prior);
  for (const Parameter parameter : kParameters) {
    const auto held = choice.fixed[static_cast<std::size_t>(parameter)];
    if (held)
      text += "; " + std::string(parameterName(parameter)) + " was held at " +
              formatNumber(*held, kNoiseDigits);
  }
  return text + ".";
}

std::string sourceWords(const Scene& scene) {
  const Rig& rig = scene.source->measurements.rig;
  if (scene.source->image) return "from an albedo texture";
  const std::string lights = rig.lights.size() == 1 ? " under the light " : " under the lights ";
  return "from photographs by the camera " + rig.camera.name + lights +
         listed(rig.lights, " and ") + " (rig " + rig.name + ")";
}

std::string extrapolationSentence(const Rig& rig) {
  const auto band = measuredBand(responseRows(rig));
  if (!band) return {};
  return " Outside of " + formatNumber(wavelengthNm(band->first), 4) + " to " +
         formatNumber(wavelengthNm(band->last), 4) +
         " nm reflectance was not measured; there it is what the model extrapolates.";
}

}  // namespace

std::string methodsText(const Scene& scene, const FitChoice& choice, const std::string& version) {
  const std::string profile = shortNameOf(choice.profile);
  const std::string model =
      "the two-layer skin model of Li et al. (2024) with the profile " + profile;
  if (scene.source == nullptr) {
    return "Reflectance spectra were computed with Cutis " + version + " by " + model +
           " from maps of chromophores that had been fitted before.\n\n" + kPaper + "\n";
  }
  const Rig& rig = scene.source->measurements.rig;
  std::string text =
      "Melanin, melanin blend, dermal and epidermal haemoglobin and β-carotene were "
      "estimated for each pixel " +
      sourceWords(scene) + " with Cutis " + version + ", by " + model + ": " +
      methodWords(choice.method) + ".";
  if (choice.method == FitMethod::refined)
    text += " " + noiseSentence(noiseOf(rig, choice)) + " " + priorSentence(choice);
  if (choice.shading) text += " Shading was estimated as one more factor for each pixel.";
  text += " The model gives the reflectance from 300 to 1000 nm." + extrapolationSentence(rig);
  return text + "\n\n" + kPaper + "\n";
}

std::string captionText(const Scene& scene, const FitChoice& choice, const std::string& version) {
  std::string text = "Profile " + shortNameOf(choice.profile);
  if (scene.source != nullptr) {
    const Rig& rig = scene.source->measurements.rig;
    text += " · rig " + rig.name + " (" + listed(rig.lights, ", ") + ")";
    if (choice.method == FitMethod::refined) {
      const NoiseModel noise = noiseOf(rig, choice);
      text += " · noise " + formatNumber(noise.read, kNoiseDigits) + " + " +
              percentText(noise.proportional, 2) + " · prior " +
              (choice.prior.empty() ? std::string("of the profile") : shortNameOf(choice.prior));
    } else {
      text += " · " + methodWords(choice.method);
    }
  }
  return text + " · Cutis\u00a0" + version;  // on one line
}

}  // namespace cutis
