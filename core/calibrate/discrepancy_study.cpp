#include "core/calibrate/discrepancy_study.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>
#include <numeric>
#include <optional>
#include <span>
#include <string>
#include <utility>

#include "core/base/number_text.h"
#include "core/base/parallel.h"
#include "core/base/random.h"
#include "core/calibrate/channel_estimate.h"
#include "core/calibrate/discrepancy_learning.h"
#include "core/evaluate/validation.h"
#include "core/skin/model/measurement_geometry.h"
#include "core/skin/model/skin_model.h"

namespace cutis {
namespace {

// The learned prior is known to no more digits.
constexpr int kLearnedPriorDigits = 4;
// Where a darker skin's ultraviolet is all but the surface's reflection, what is left after taking
// that off is error, and may be negative.
constexpr double kLeastRemoved = 0.003;
// The relative noise of channels without noise: what arithmetic and nodes leave.
constexpr double kLeastNoise = 3e-4;
constexpr double kNotJudged = std::numeric_limits<double>::quiet_NaN();
// Which of the random sequences.
constexpr std::uint64_t kHalfStream = 11, kPhotographStream = 1000;
constexpr std::array<WavelengthRange, kGainRangeCount> kGainRanges = {
    kUltravioletRange, kFittedRange, kNearInfraredRange};

MeasurementGeometry geometryOf(const DiscrepancyStudy& study, SpecularPart part) {
  return measurementGeometry(part, study.profile.refractiveIndex, study.spectra.specularShare);
}

// As if measured with the surface's reflection or without it.
SpectraSet asSeen(const DiscrepancyStudy& study, SurfaceLight surface) {
  const MeasuredSpectra& spectra = study.spectra.spectra;
  const MeasurementGeometry own = geometryOf(study, study.spectra.specular);
  const MeasurementGeometry other = geometryOf(study, SpecularPart::included);
  const bool asMeasured =
      surface == SurfaceLight::included && study.spectra.specular == SpecularPart::included;
  SpectraSet set;
  for (int sample = 0; sample < kSampleCount; ++sample) {
    const double wavelength = wavelengthNm(sample);
    if (wavelength < spectra.wavelengthsNm.front() || wavelength > spectra.wavelengthsNm.back())
      continue;
    set.samples.push_back(sample);
  }
  set.measured.resize(static_cast<Eigen::Index>(set.samples.size()),
                      static_cast<Eigen::Index>(spectra.ids.size()));
  for (std::size_t i = 0; i < spectra.ids.size(); ++i) {
    Spectrum spectrum = onGrid(spectra, i);
    for (double& value : spectrum) {
      if (asMeasured || !(value > 0.0)) continue;
      value = std::max(modelReflectance(own, value), kLeastRemoved);
      if (surface == SurfaceLight::included) value = measuredReflectance(other, value);
    }
    set.measured.col(static_cast<Eigen::Index>(i)) = spectrum(set.samples);
  }
  return set;
}

Result<Discrepancy> learnedFrom(const SkinModel& model, const DiscrepancyStudy& study,
                                const SpectraSet& set, const JobContext& context) {
  DiscrepancyLearning options;
  options.components = study.components;
  options.prior = study.profile.prior;
  options.edgeLossPerMm = study.spectra.edgeLossPerMm;
  CUTIS_TRY(discrepancy, learnDiscrepancy(model, set, options, context));
  for (int k = 0; k < kParameterCount; ++k) {
    discrepancy.prior.mean[k] = roundedTo(discrepancy.prior.mean[k], kLearnedPriorDigits);
    discrepancy.prior.deviation[k] = roundedTo(discrepancy.prior.deviation[k], kLearnedPriorDigits);
  }
  return discrepancy;
}

// The rig's channels over the wavelengths that were measured, each summing to 1; those that see
// nothing there are left out.
SpectrumRows channelsWithin(const SpectraSet& set, const Rig& rig) {
  SpectrumRows rows = responseRows(rig);
  rows.leftCols(set.samples.front()) = 0.0;
  rows.rightCols(kSampleCount - 1 - set.samples.back()) = 0.0;
  Eigen::Index seeing = 0;
  for (Eigen::Index k = 0; k < rows.rows(); ++k) {
    const double sum = rows.row(k).sum();
    if (sum > 0.0) rows.row(seeing++) = rows.row(k) / sum;
  }
  return rows.topRows(seeing);
}

// Over the samples of a set; zero where nothing was measured.
Spectrum spectrumOf(const SpectraSet& set, Eigen::Index index) {
  Spectrum spectrum = Spectrum::Zero();
  spectrum(set.samples) = set.measured.col(index);
  return spectrum;
}

double errorOver(const WavelengthRange& range, const SpectraSet& set, Eigen::Index index,
                 const Spectrum& estimated) {
  double sum = 0.0, count = 0.0;
  for (std::size_t s = 0; s < set.samples.size(); ++s) {
    if (!range.contains(wavelengthNm(set.samples[s]))) continue;
    const double off =
        estimated[set.samples[s]] - set.measured(static_cast<Eigen::Index>(s), index);
    sum += off * off;
    count += 1.0;
  }
  return std::sqrt(sum / count);
}

// Photographs the people of a set and estimates their spectra.
class Judge {
 public:
  Judge(const DiscrepancyStudy& study, const SkinModel& model, const SpectraSet& set)
      : study_(study), model_(model), set_(set), rangeErrors_(study.channels.size()) {
    for (const JudgedChannels& channels : study.channels)
      rows_.push_back(channelsWithin(set, channels.rig));
  }

  // `people`, none of whom the discrepancy was learned from.
  Status judge(const std::optional<Discrepancy>& discrepancy, std::span<const std::size_t> people,
               std::uint64_t half, const JobContext& context) {
    for (std::size_t c = 0; c < rows_.size(); ++c) {
      const JudgedChannels& channels = study_.channels[c];
      // Without a discrepancy its errors need room: the model alone is never believed beyond the
      // rig's noise.
      const double believed = std::max(channels.noise, kLeastNoise);
      const ChannelEstimator with(model_, rows_[c], believed, study_.profile.prior, discrepancy);
      const ChannelEstimator without(model_, rows_[c],
                                     std::max(believed, channels.rig.noise.proportional),
                                     study_.profile.prior, {});
      std::vector<std::array<DiscrepancyGain, kGainRangeCount>> errors(people.size());
      CUTIS_CHECK(parallelFor(people.size(), context, [&](std::size_t i) -> Status {
        const auto person = static_cast<Eigen::Index>(people[i]);
        Eigen::VectorXd seen = rows_[c].matrix() * spectrumOf(set_, person).matrix();
        Random random(study_.seed + half, kPhotographStream + people[i]);
        for (double& channel : seen)
          channel *= std::max(1.0 + channels.noise * random.normal(), kLeastNoise);
        const Spectrum one = with.reflectance(seen), other = without.reflectance(seen);
        for (std::size_t range = 0; range < kGainRangeCount; ++range) {
          errors[i][range] = {errorOver(kGainRanges[range], set_, person, other),
                              errorOver(kGainRanges[range], set_, person, one)};
        }
        return {};
      }));
      rangeErrors_[c].push_back(mediansOf(errors));
    }
    return {};
  }

  std::vector<std::array<DiscrepancyGain, kGainRangeCount>> gains() const {
    std::vector<std::array<DiscrepancyGain, kGainRangeCount>> gains;
    for (const auto& halves : rangeErrors_) {
      gains.emplace_back();
      const auto count = static_cast<double>(halves.size());
      for (std::size_t range = 0; range < kGainRangeCount; ++range) {
        DiscrepancyGain& gain = gains.back()[range];
        if (halves.empty()) gain = {kNotJudged, kNotJudged};
        for (const auto& half : halves) {
          gain.without += half[range].without / count;
          gain.with += half[range].with / count;
        }
      }
    }
    return gains;
  }

 private:
  static std::array<DiscrepancyGain, kGainRangeCount> mediansOf(
      const std::vector<std::array<DiscrepancyGain, kGainRangeCount>>& errors) {
    std::array<DiscrepancyGain, kGainRangeCount> medians;
    for (std::size_t range = 0; range < kGainRangeCount; ++range) {
      std::vector<double> with, without;
      for (const auto& person : errors) {
        with.push_back(person[range].with);
        without.push_back(person[range].without);
      }
      medians[range] = {kNotJudged, kNotJudged};
      if (std::isnan(with.front())) continue;
      medians[range] = {distributionOf(without).median, distributionOf(with).median};
    }
    return medians;
  }

  const DiscrepancyStudy& study_;
  const SkinModel& model_;
  const SpectraSet& set_;
  std::vector<SpectrumRows> rows_;  // [channels]
  std::vector<std::vector<std::array<DiscrepancyGain, kGainRangeCount>>>
      rangeErrors_;  // [channels][half]
};

// All people in an order of chance.
std::vector<std::size_t> shuffledPeople(Eigen::Index count, std::uint64_t seed) {
  Random random(seed, kHalfStream);
  std::vector<std::size_t> order(static_cast<std::size_t>(count));
  std::iota(order.begin(), order.end(), std::size_t{0});
  for (std::size_t i = order.size(); i > 1; --i)
    std::swap(order[i - 1], order[random.bits() % i]);
  return order;
}

}  // namespace

std::size_t fewestToHalve(const DiscrepancyStudy& study) {
  return 2 * static_cast<std::size_t>(std::max(kFewestPeople, study.components + 1));
}

Result<DiscrepancyFigures> runDiscrepancyStudy(const DiscrepancyStudy& study,
                                               const JobContext& context) {
  const double parts = 2.0 + 2.0 * study.halvings;
  double done = 0.0;
  const auto next = [&](const std::string& stage) {
    done += 1.0;
    return context.child((done - 1.0) / parts, done / parts, stage);
  };
  const JobContext silent = {context.stop, {}, {}};
  CUTIS_TRY(model, SkinModel::create(study.profile, silent));
  DiscrepancyFigures figures;
  const SpectraSet included = asSeen(study, SurfaceLight::included);
  CUTIS_TRY(withSurface, learnedFrom(*model, study, included, next("learning")));
  figures.discrepancies.surfaceIncluded = withSurface;
  const SpectraSet removed = asSeen(study, SurfaceLight::removed);
  CUTIS_TRY(belowSurface, learnedFrom(*model, study, removed, next("learning")));
  figures.discrepancies.surfaceRemoved = belowSurface;

  Judge judge(study, *model, included);
  for (int halving = 0; halving < study.halvings; ++halving) {
    const std::uint64_t seed = study.seed + static_cast<std::uint64_t>(halving);
    const std::vector<std::size_t> order = shuffledPeople(included.count(), seed);
    const std::span<const std::size_t> all = order;
    const std::span<const std::size_t> halves[] = {all.first(all.size() / 2),
                                                   all.subspan(all.size() / 2)};
    for (std::size_t half = 0; half < 2; ++half) {
      const JobContext stage = next("judging people left out");
      CUTIS_TRY(learned, learnedFrom(*model, study, selected(included, halves[half]), stage));
      CUTIS_CHECK(judge.judge(learned, halves[1 - half],
                              2 * static_cast<std::uint64_t>(halving) + half, silent));
    }
  }
  figures.gains = judge.gains();
  return figures;
}

}  // namespace cutis
