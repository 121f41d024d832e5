#include "core/evaluate/error_metrics.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/base/parallel.h"
#include "core/maths/quantile.h"

namespace cutis {
namespace {

constexpr std::size_t kBatch = 128;

// Lower ends of the groups but the last, degrees.
constexpr std::array<double, kToneCount - 1> kToneLimits = {41.0, 10.0, -30.0};

// Spectra of several people: one row per sample.
using SpectraView =
    Eigen::Map<const Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>>;

double meanSquare(const SpectraView& a, const SpectraView& b, Eigen::Index pixel,
                  const Band& band) {
  const auto difference = a.col(pixel).segment(band.first, band.count()) -
                          b.col(pixel).segment(band.first, band.count());
  return difference.squaredNorm() / band.count();
}

ParameterVector estimateAt(std::span<const float> estimates, std::size_t count, std::size_t i) {
  ParameterVector person;
  for (std::size_t k = 0; k < kParameterCount; ++k) {
    person[static_cast<Eigen::Index>(k)] = double{estimates[k * count + i]};
  }
  return person;
}

}  // namespace

ErrorSummary summarise(std::span<const PixelError> errors) {
  ErrorSummary summary;
  summary.pixels = errors.size();
  if (errors.empty()) return summary;
  const auto count = static_cast<double>(errors.size());
  std::vector<double> underDaylight, underIncandescent;
  for (const PixelError& error : errors) {
    summary.visibleMse += error.visible / count;
    summary.ultravioletMse += error.ultraviolet / count;
    summary.nearInfraredMse += error.nearInfrared / count;
    summary.parameterRmse += error.parameters.square() / count;
    underDaylight.push_back(error.deltaE_D65);
    underIncandescent.push_back(error.deltaE_A);
  }
  summary.parameterRmse = summary.parameterRmse.sqrt().eval();
  summary.medianDeltaE_D65 = quantileOf(underDaylight, 0.5);
  summary.deltaE95_D65 = quantileOf(underDaylight, 0.95);
  summary.medianDeltaE_A = quantileOf(underIncandescent, 0.5);
  summary.deltaE95_A = quantileOf(underIncandescent, 0.95);
  return summary;
}

int toneOf(double typologyAngle) {
  int tone = 0;
  while (tone < kToneCount - 1 && typologyAngle <= kToneLimits[static_cast<std::size_t>(tone)])
    ++tone;
  return tone;
}

const char* toneName(int tone) {
  constexpr std::array<const char*, kToneCount> names = {"light", "medium", "brown", "dark"};
  return names[static_cast<std::size_t>(tone)];
}

ErrorMeter::ErrorMeter(const SkinModel& model, const Spectrum& d65, const Spectrum& a,
                       const Sensor& observer)
    : spectra_(model),
      daylight_{tristimulusRows(d65, observer).matrix(), whitePoint(d65, observer)},
      incandescent_{tristimulusRows(a, observer).matrix(), whitePoint(a, observer)} {}

Result<std::vector<PixelError>> ErrorMeter::measure(std::span<const ParameterVector> people,
                                                    std::span<const float> estimates,
                                                    const JobContext& context) const {
  std::vector<PixelError> errors(people.size());
  const std::size_t batches = (people.size() + kBatch - 1) / kBatch;
  CUTIS_CHECK(parallelFor(batches, context, [&](std::size_t piece) -> Status {
    const std::size_t first = piece * kBatch;
    const std::size_t count = std::min(kBatch, people.size() - first);
    std::vector<ParameterVector> estimated;
    for (std::size_t i = 0; i < count; ++i)
      estimated.push_back(estimateAt(estimates, people.size(), first + i));
    std::vector<double> trueValues, estimatedValues;
    spectra_.evaluate(people.subspan(first, count), trueValues);
    spectra_.evaluate(estimated, estimatedValues);
    const auto columns = static_cast<Eigen::Index>(count);
    const SpectraView truth(trueValues.data(), kSampleCount, columns);
    const SpectraView estimate(estimatedValues.data(), kSampleCount, columns);
    const auto lab = [](const Colours& colours, const SpectraView& spectra) {
      Eigen::Matrix3Xd values = colours.rows * spectra;
      for (Eigen::Index i = 0; i < values.cols(); ++i)
        values.col(i) = labFromXyz(values.col(i), colours.white);
      return values;
    };
    const Eigen::Matrix3Xd trueDaylight = lab(daylight_, truth);
    const Eigen::Matrix3Xd ofDaylight = lab(daylight_, estimate);
    const Eigen::Matrix3Xd trueIncandescent = lab(incandescent_, truth);
    const Eigen::Matrix3Xd incandescent = lab(incandescent_, estimate);
    for (Eigen::Index i = 0; i < columns; ++i) {
      const auto n = static_cast<std::size_t>(i);
      PixelError& error = errors[first + n];
      error.visible = meanSquare(truth, estimate, i, kVisibleBand);
      error.ultraviolet = meanSquare(truth, estimate, i, kUltravioletBand);
      error.nearInfrared = meanSquare(truth, estimate, i, kNearInfraredBand);
      error.deltaE_D65 = deltaE2000(trueDaylight.col(i), ofDaylight.col(i));
      error.deltaE_A = deltaE2000(trueIncandescent.col(i), incandescent.col(i));
      error.typologyAngle = individualTypologyAngle(trueDaylight.col(i));
      error.parameters = estimated[n] - people[first + n];
    }
    return {};
  }));
  return errors;
}

double Coverage::Count::share() const {
  if (pixels == 0) return std::numeric_limits<double>::quiet_NaN();
  return static_cast<double>(inside) / static_cast<double>(pixels);
}

Coverage coverageOf(std::span<const ParameterVector> people, std::span<const float> estimates,
                    std::span<const float> deviations, const Prior& prior) {
  Coverage coverage;
  for (std::size_t i = 0; i < people.size(); ++i) {
    const ParameterVector estimate = estimateAt(estimates, people.size(), i);
    const ParameterVector deviation = estimateAt(deviations, people.size(), i);
    for (int k = 0; k < kParameterCount; ++k) {
      // The deviation of a logarithm is relative.
      const bool isLog = prior.isLog(k);
      const double spread = isLog ? deviation[k] / estimate[k] : deviation[k];
      const double away = isLog ? std::log(estimate[k] / people[i][k]) : estimate[k] - people[i][k];
      const auto index = static_cast<std::size_t>(k);
      Coverage::Count& count =
          spread < 0.5 * prior.deviation[k] ? coverage.measured[index] : coverage.assumed[index];
      ++count.pixels;
      if (std::abs(away) <= 2.0 * spread) ++count.inside;
    }
  }
  return coverage;
}

}  // namespace cutis
