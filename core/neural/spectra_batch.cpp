#include "core/neural/spectra_batch.h"

#include <algorithm>
#include <numeric>

#include "core/base/parallel.h"
#include "core/skin/model/reflectance_batch.h"

namespace cutis {
namespace {

constexpr std::size_t kBlock = 512;

std::vector<int> allSamples() {
  std::vector<int> samples(kSampleCount);
  std::iota(samples.begin(), samples.end(), 0);
  return samples;
}

}  // namespace

SpectraSource::SpectraSource(const SkinModel& model) : nodes_(model, allSamples()) {}

SpectraBlock SpectraSource::spectra(const ParameterVector* people, std::size_t count) const {
  const PixelBuffer<float> parameters = parameterRows<float>({people, count});
  SpectraBlock block(static_cast<Eigen::Index>(count), kSampleCount);
  reflectanceBatch<float>(nodes_, parameters.rows(), packedRows(block.data(), kSampleCount, count));
  return block;
}

Status SpectraSource::forEachBlock(
    const std::vector<ParameterVector>& people, const JobContext& context,
    const std::function<void(std::size_t, const SpectraBlock&)>& work) const {
  const std::size_t blocks = (people.size() + kBlock - 1) / kBlock;
  return parallelFor(blocks, context, [&](std::size_t i) -> Status {
    const std::size_t first = i * kBlock;
    work(first, spectra(people.data() + first, std::min(kBlock, people.size() - first)));
    return {};
  });
}

}  // namespace cutis
