#include "src/cli/commands/rig/rig_identify.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "core/fit/population.h"
#include "core/rig/narrowband.h"
#include "src/cli/text_table.h"
#include "src/files/io/csv.h"
#include "src/files/spectral_library.h"

namespace cutis {
namespace {

constexpr std::uint64_t kSeed = 6;
constexpr std::array<double, 5> kNoises = {0.001, 0.002, 0.005, 0.01, 0.02};
constexpr std::size_t kBestLights = 8;
// Narrow lights, as light-emitting diodes are: their middle and the width at half of their height.
constexpr int kFirstMiddleNm = 360, kLastMiddleNm = 960, kMiddleStepNm = 20;
constexpr double kHalfWidthNm = 20.0;

Spectrum narrowLight(int middleNm) {
  Spectrum power;
  for (int i = 0; i < kSampleCount; ++i) {
    const double away = (wavelengthNm(i) - middleNm) / kHalfWidthNm;
    power[i] = std::exp2(-4.0 * away * away);
  }
  return power;
}

Result<std::vector<RigLight>> candidateLights() {
  std::vector<RigLight> lights;
  for (int nm = kFirstMiddleNm; nm <= kLastMiddleNm; nm += kMiddleStepNm) {
    lights.push_back({std::to_string(nm) + " nm, 20 nm wide", narrowLight(nm), {}});
  }
  for (const std::string& name : lightNames()) {
    CUTIS_TRY(power, loadLight({name, {}, {}}));
    lights.push_back({name, power, {}});
  }
  return lights;
}

// Whether most of a light lies where the camera sees; beyond, its curves say nothing.
bool isInSight(const RigLight& light, const Camera& camera) {
  constexpr double kBlind = 1e-3;  // of its largest sensitivity
  const Eigen::ArrayXd sees = camera.sensor.sensitivity.colwise().maxCoeff().transpose();
  const double seen = (sees > kBlind * sees.maxCoeff()).select(light.power, 0.0).sum();
  return seen > 0.5 * light.power.sum();
}

ChannelSet channelsOf(const Rig& rig) {
  return {responseRows(rig), rig.noise.isExact() ? NoiseModel() : rig.noise, {}};
}

std::string counted(const std::string& what, Eigen::Index channels) {
  return what + ", " + std::to_string(channels) + " channels";
}

void compareChannels(const Rig& rig, const IdentifiabilityStudy& study, RigFigures& figures) {
  const ChannelSet all = channelsOf(rig);
  figures.channels.push_back({counted("all", all.rows.rows()), study.of(all)});
  const SearchChannels five = searchChannels(rig);
  if (five.hasNarrowband()) {
    ChannelSet combined = all;
    combined.combination = five.fromRig;
    figures.channels.push_back({"r, g, b, sb, sg of the paper", study.of(combined)});
  }
  if (rig.lights.size() < 2) return;
  for (const RigLight& light : rig.lights) {
    Rig one = rig;
    one.lights = {light};
    figures.channels.push_back({counted(light.name + " alone", 3), study.of(channelsOf(one))});
  }
}

void compareNoises(const Rig& rig, const IdentifiabilityStudy& study, RigFigures& figures) {
  ChannelSet channels = channelsOf(rig);
  for (const double noise : kNoises) {
    channels.noise.proportional = noise;
    figures.noises.push_back({formatNumber(100.0 * noise, 3) + " %", study.of(channels)});
  }
}

// How much is left open of everything: the mean logarithm over the parameters.
double uncertaintyOf(const Identifiability& result) {
  double sum = 0.0;
  for (const Spread& spread : result.left)
    sum += std::log(spread.median);
  return sum;
}

Status compareLights(const Rig& rig, const IdentifiabilityStudy& study, const JobContext& context,
                     RigFigures& figures) {
  CUTIS_TRY(candidates, candidateLights());
  double done = 0.0;
  for (const RigLight& light : candidates) {
    if (context.stopRequested()) return Cancelled{};
    context.progress.report(done++ / static_cast<double>(candidates.size()));
    if (!isInSight(light, rig.camera)) continue;
    Rig more = rig;
    more.lights.push_back(light);
    figures.lights.push_back({light.name, study.of(channelsOf(more))});
  }
  std::stable_sort(figures.lights.begin(), figures.lights.end(), [](const auto& a, const auto& b) {
    return uncertaintyOf(a.result) < uncertaintyOf(b.result);
  });
  figures.lights.resize(std::min(figures.lights.size(), kBestLights));
  return {};
}

std::string percent(double share) {
  return fixedNumber(100.0 * share, 0);
}

std::string tableOf(const std::string& heading, const std::vector<MeasurementFigures>& rows) {
  std::vector<std::string> head = {heading};
  for (const Parameter parameter : kParameters)
    head.emplace_back(parameterSymbol(parameter));
  for (const char* band : {"vis", "UV", "NIR"})
    head.emplace_back(band);
  TextTable table(head);
  for (const MeasurementFigures& row : rows) {
    std::vector<std::string> cells = {row.name};
    for (const Spread& spread : row.result.left) {
      cells.push_back(percent(spread.median) + " (" + percent(spread.low) + "–" +
                      percent(spread.high) + ")");
    }
    for (const double deviation :
         {row.result.visible, row.result.ultraviolet, row.result.nearInfrared}) {
      cells.push_back(fixedNumber(deviation, 4));
    }
    table.add(cells);
  }
  return table.text();
}

}  // namespace

Result<RigFigures> identifyRig(const SkinModel& model, const Rig& rig, const Prior& prior,
                               std::size_t people, const JobContext& context) {
  const auto drawn = drawFromPrior(prior, model.profile().axes, static_cast<int>(people), kSeed);
  CUTIS_TRY(study, IdentifiabilityStudy::create(model, prior, drawn, context.child(0.0, 0.1)));
  RigFigures figures;
  figures.rig = rig.name;
  figures.profile = model.profile().name;
  figures.people = people;
  figures.noise = channelsOf(rig).noise;
  compareChannels(rig, study, figures);
  compareNoises(rig, study, figures);
  if (static_cast<int>(rig.lights.size()) < kMaximumLights) {
    CUTIS_CHECK(compareLights(rig, study, context.child(0.1, 1.0), figures));
  }
  return figures;
}

std::string rigTables(const RigFigures& figures) {
  std::string text =
      "rig " + figures.rig + ", profile " + figures.profile + ", " +
      std::to_string(figures.people) + " people of the prior, noise " +
      formatNumber(figures.noise.read, 3) + " and " +
      formatNumber(100.0 * figures.noise.proportional, 3) + " %\n" +
      "Parameters: what stays open of the prior's deviation, in percent: median (5–95 % of the\n"
      "people); 0 is known, 100 is guessed. Spectra: root mean square deviation of the predicted\n"
      "reflectance, 400–700, 300–400 and 700–1000 nm.\n\n";
  text += tableOf("channels", figures.channels);
  text += "\n" + tableOf("all, noise", figures.noises);
  if (figures.lights.empty()) return text;
  return text + "\n" + tableOf("one more light, best first", figures.lights);
}

}  // namespace cutis
