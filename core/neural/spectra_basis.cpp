#include "core/neural/spectra_basis.h"

#include <algorithm>
#include <cassert>
#include <vector>

#include "core/base/parallel.h"
#include "core/maths/decompositions.h"
#include "core/neural/spectra_batch.h"

namespace cutis {
namespace {

using Eigen::Index;

// Parts of the table with sums of their own, which are added in their order.
constexpr std::int64_t kParts = 24;
// Entries at a time: the work between two looks at the stop token.
constexpr std::int64_t kChunk = 512;

std::int64_t tableEntries(const ParameterAxes& axes) {
  std::int64_t size = 1;
  for (const ParameterAxis& axis : axes)
    size *= axis.samples;
  return size;
}

// Entries in any fixed order: the last parameter runs fastest.
ParameterVector tableEntry(const ParameterAxes& axes, std::int64_t entry) {
  ParameterVector values;
  for (int k = kParameterCount; k-- > 0;) {
    const ParameterAxis& axis = axes[static_cast<std::size_t>(k)];
    values[k] = axis.value(static_cast<double>(entry % axis.samples));
    entry /= axis.samples;
  }
  return values;
}

// Sums over spectra of their distance from a reference spectrum and of its outer product.
struct SpectraSums {
  Eigen::VectorXd first = Eigen::VectorXd::Zero(kSampleCount);
  Eigen::MatrixXd second;  // lower triangle

  void add(const SpectraBlock& block, const Eigen::VectorXd& reference) {
    const Eigen::MatrixXd away =
        (block.cast<double>().rowwise() - reference.transpose()).transpose();
    first += away.rowwise().sum();
    if (second.size() == 0) second = Eigen::MatrixXd::Zero(kSampleCount, kSampleCount);
    second.selfadjointView<Eigen::Lower>().rankUpdate(away);
  }
};

struct TableWalk {
  const SkinModel& model;
  const SpectraSource& source;
  Eigen::VectorXd reference;
  std::int64_t count = 0;  // entries to take, `stride` apart
  std::int64_t stride = 1;
};

Status addPart(const TableWalk& walk, std::int64_t part, const JobContext& context,
               SpectraSums& sums) {
  const ParameterAxes& axes = walk.model.profile().axes;
  const std::int64_t end = walk.count * (part + 1) / kParts;
  std::vector<ParameterVector> people;
  for (std::int64_t at = walk.count * part / kParts; at < end; at += kChunk) {
    if (context.stopRequested()) return Cancelled{};
    people.clear();
    for (std::int64_t i = at; i < std::min(at + kChunk, end); ++i) {
      people.push_back(tableEntry(axes, i * walk.stride));
    }
    sums.add(walk.source.spectra(people.data(), people.size()), walk.reference);
  }
  return {};
}

SpectraBasis basisOf(const std::vector<SpectraSums>& parts, const TableWalk& walk) {
  Eigen::VectorXd first = Eigen::VectorXd::Zero(kSampleCount);
  Eigen::MatrixXd second = Eigen::MatrixXd::Zero(kSampleCount, kSampleCount);
  for (const SpectraSums& part : parts) {
    if (part.second.size() == 0) continue;
    first += part.first;
    second += part.second;
  }
  const auto count = static_cast<double>(walk.count);
  first /= count;
  const Eigen::MatrixXd covariance = second / count - first * first.transpose();
  const SymmetricEigen eigen = symmetricEigen(covariance);

  SpectraBasis basis;
  basis.spectra = walk.count;
  basis.mean = (walk.reference + first).array();
  // Eigenvalues increase; rounding may leave the least of them below zero.
  basis.variances = eigen.values.reverse().cwiseMax(0.0);
  basis.components = eigen.vectors.rowwise().reverse().leftCols(kMaximumComponents);
  for (Index k = 0; k < basis.components.cols(); ++k) {
    Index largest = 0;
    basis.components.col(k).cwiseAbs().maxCoeff(&largest);
    if (basis.components(largest, k) < 0.0) basis.components.col(k) *= -1.0;
  }
  return basis;
}

}  // namespace

double SpectraBasis::truncationError(int count) const {
  return variances.tail(variances.size() - count).sum() / kSampleCount;
}

int SpectraBasis::componentsFor(double error) const {
  int count = 0;
  while (count < kMaximumComponents && truncationError(count) > error)
    ++count;
  return count;
}

Result<SpectraBasis> computeSpectraBasis(const SkinModel& model, const JobContext& context,
                                         int stride) {
  assert(stride >= 1);
  const ParameterAxes& axes = model.profile().axes;
  const SpectraSource source(model);
  const std::int64_t entries = tableEntries(axes);
  TableWalk walk = {model, source, {}, (entries + stride - 1) / stride, stride};
  // Near the mean, so that little is lost when the squared mean is taken away.
  walk.reference = model.reflectance(tableEntry(axes, entries / 2)).matrix();
  std::vector<SpectraSums> parts(static_cast<std::size_t>(kParts));
  CUTIS_CHECK(parallelFor(parts.size(), context, [&](std::size_t part) {
    return addPart(walk, static_cast<std::int64_t>(part), context, parts[part]);
  }));
  return basisOf(parts, walk);
}

}  // namespace cutis
