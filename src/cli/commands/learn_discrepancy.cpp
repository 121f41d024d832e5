#include "src/cli/commands/learn_discrepancy.h"

#include <array>
#include <cmath>
#include <utility>

#include "core/base/number_text.h"
#include "src/cli/text_table.h"
#include "src/files/profiles/calibrated_profile.h"
#include "src/files/rig_file.h"

namespace cutis {
namespace {

constexpr char kJudgedRig[] = "monitor";
constexpr char kJudgedColorRig[] = "albedo";
constexpr double kJudgedNoise = 0.005;
constexpr int kGainDecimals = 4;
constexpr std::array<const char*, kGainRangeCount> kRangeLabels = {"320-400 nm", "400-700 nm",
                                                                   "700-1000 nm"};
constexpr std::array kRangeOrder = {GainRange::visible, GainRange::ultraviolet,
                                    GainRange::nearInfrared};

std::string channelsLabel(const JudgedChannels& channels) {
  const std::string noise =
      channels.noise == 0.0 ? "no noise" : formatNumber(100.0 * channels.noise) + " % noise";
  return channels.rig.name + ", " + noise;
}

std::string gainTableOf(const DiscrepancyStudy& study, const DiscrepancyFigures& figures) {
  TextTable table({"median RMSE on people left out", "over", "without", "with"}, 2);
  for (std::size_t c = 0; c < study.channels.size(); ++c) {
    for (const GainRange range : kRangeOrder) {
      const auto index = static_cast<std::size_t>(range);
      const DiscrepancyGain& gain = figures.gains[c][index];
      if (std::isnan(gain.with)) continue;
      table.add({channelsLabel(study.channels[c]), kRangeLabels[index],
                 fixedNumber(gain.without, kGainDecimals), fixedNumber(gain.with, kGainDecimals)});
    }
  }
  return table.text();
}

}  // namespace

Result<LearnedProfile> learnProfile(const CalibrationRecipe& recipe, const MeasuredSpectra& spectra,
                                    int halvings, std::uint64_t seed, const std::string& place,
                                    const JobContext& context) {
  CUTIS_TRY(study, discrepancyStudyOf(recipe, spectra));
  CUTIS_TRY(photographs, loadRig(kJudgedRig, {}, "rig"));
  CUTIS_TRY(color, loadRig(kJudgedColorRig, {}, "rig"));
  study.channels = {{photographs, 0.0}, {photographs, kJudgedNoise}, {color, 0.0}};
  study.halvings = halvings;
  study.seed = seed;
  if (halvings > 0 && spectra.ids.size() < fewestToHalve(study)) {
    return inputError(
        place, "too few spectra to judge on halves of them: " + std::to_string(spectra.ids.size()) +
                   " where at least " + std::to_string(fewestToHalve(study)) +
                   " are needed; --halvings 0 learns without judging");
  }
  const Result<DiscrepancyFigures> figures = runDiscrepancyStudy(study, context);
  if (figures.failed()) return Error{figures.error().kind, place, figures.error().message};
  if (!figures) return figures.failure();
  CUTIS_TRY(text, learnedProfileText(recipe, figures.value().discrepancies, spectra.ids.size()));
  return LearnedProfile{text, halvings > 0 ? gainTableOf(study, figures.value()) : std::string()};
}

}  // namespace cutis
