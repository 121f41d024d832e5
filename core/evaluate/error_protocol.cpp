#include "core/evaluate/error_protocol.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

#include "core/base/half.h"
#include "core/base/parallel.h"
#include "core/base/random.h"
#include "core/simulate/counter_normal.h"
#include "core/skin/model/reflectance_batch.h"
#include "core/spectra/colorimetry.h"

namespace cutis {
namespace {

// People evaluated at once: their spectra stay in the cache.
constexpr std::size_t kPixelsAtOnce = 128;

std::vector<int> allSamples() {
  std::vector<int> samples(kSampleCount);
  std::iota(samples.begin(), samples.end(), 0);
  return samples;
}

double inSteps(double value, double steps) {
  return std::round(std::clamp(value, 0.0, 1.0) * steps) / steps;
}

void encode(std::span<float> values, SampleEncoding encoding) {
  switch (encoding) {
    case SampleEncoding::float32:
      return;
    case SampleEncoding::half: {
      std::vector<std::uint16_t> halves(values.size());
      convertFloatToHalf(values, halves);
      convertHalfToFloat(halves, values);
      return;
    }
    case SampleEncoding::linear16:
      for (float& value : values)
        value = static_cast<float>(inSteps(double{value}, 65535.0));
      return;
    case SampleEncoding::srgb8:
      for (float& value : values)
        value = static_cast<float>(decodeSrgb(inSteps(encodeSrgb(double{value}), 255.0)));
      return;
  }
}

}  // namespace

Prior priorOf(const ParameterBox& box) {
  return {PriorScale::linear, 0.5 * (box.low + box.high), (box.high - box.low) / std::sqrt(12.0)};
}

FullSpectra::FullSpectra(const SkinModel& model) : nodes_(model, allSamples()) {}

void FullSpectra::evaluate(std::span<const ParameterVector> people,
                           std::vector<double>& out) const {
  const PixelBuffer<double> parameters = parameterRows<double>(people);
  out.resize(kSampleCount * people.size());
  reflectanceBatch<double>(nodes_, parameters.rows(),
                           packedRows(out.data(), kSampleCount, people.size()));
}

Result<ProtocolPixels> ProtocolPixels::create(const SkinModel& model, const Rig& rig,
                                              std::vector<ParameterVector> people,
                                              const JobContext& context) {
  using Matrix = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;
  const Matrix rows = responseRows(rig).matrix();
  const FullSpectra spectra(model);
  ProtocolPixels pixels;
  pixels.people_ = std::move(people);
  pixels.channelCount_ = static_cast<std::size_t>(rows.rows());
  pixels.exact_.resize(pixels.channelCount_ * pixels.count());
  Eigen::Map<Matrix> exact(pixels.exact_.data(), rows.rows(),
                           static_cast<Eigen::Index>(pixels.count()));
  const std::size_t batches = (pixels.count() + kPixelsAtOnce - 1) / kPixelsAtOnce;
  CUTIS_CHECK(parallelFor(batches, context, [&](std::size_t i) -> Status {
    const std::size_t first = i * kPixelsAtOnce;
    const std::size_t count = std::min(kPixelsAtOnce, pixels.count() - first);
    std::vector<double> reflectance;
    spectra.evaluate(std::span(pixels.people_).subspan(first, count), reflectance);
    const Eigen::Map<const Matrix> spectraHere(reflectance.data(), kSampleCount,
                                               static_cast<Eigen::Index>(count));
    exact.middleCols(static_cast<Eigen::Index>(first), static_cast<Eigen::Index>(count)) =
        rows * spectraHere;
    return {};
  }));
  return pixels;
}

std::vector<float> ProtocolPixels::photograph(double noise, std::uint64_t seed,
                                              SampleEncoding encoding) const {
  std::vector<float> channels(exact_.size());
  for (std::size_t i = 0; i < exact_.size(); ++i) {
    const double factor = noise > 0.0 ? 1.0 + noise * double{normalAt(mixBits(seed), i)} : 1.0;
    channels[i] = static_cast<float>(std::max(0.0, exact_[i] * factor));
  }
  encode(channels, encoding);
  return channels;
}

}  // namespace cutis
