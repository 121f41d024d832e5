#include "core/fit/population.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

#include <Eigen/Cholesky>

#include "core/base/random.h"

namespace cutis {
namespace {

// Keeps the draws of a prior apart from those of the box.
constexpr std::uint64_t kPriorStream = 7;
constexpr int kTries = 64;

// One draw, as it comes. factor: of the correlation.
ParameterVector drawOnce(const Prior& prior, const ParameterMatrix& factor, Random& random) {
  ParameterVector normal;
  for (double& value : normal)
    value = random.normal();
  const ParameterVector away = (factor * normal.matrix()).array() * prior.deviation;
  ParameterVector person;
  for (int k = 0; k < kParameterCount; ++k) {
    person[k] = prior.isLog(k) ? prior.mean[k] * std::exp(away[k]) : prior.mean[k] + away[k];
  }
  return person;
}

}  // namespace

ParameterBox protocolPopulation() {
  return {{0.01, 0.2, 0.005, 0.0, 0.0}, {0.25, 1.0, 0.1, 0.05, 0.004}};
}

std::vector<ParameterVector> drawPopulation(const ParameterBox& box, int count,
                                            unsigned long long seed) {
  Random random(seed);
  std::vector<ParameterVector> people(static_cast<std::size_t>(count));
  for (ParameterVector& p : people) {
    for (int k = 0; k < kParameterCount; ++k)
      p[k] = random.uniform(box.low[k], box.high[k]);
  }
  return people;
}

std::vector<ParameterVector> drawFromPrior(const Prior& prior, const ParameterAxes& axes, int count,
                                           std::uint64_t seed) {
  ParameterVector most;
  for (std::size_t k = 0; k < axes.size(); ++k) {
    most[static_cast<Eigen::Index>(k)] = axes[k].maximum;
  }
  const ParameterMatrix factor = prior.correlation.llt().matrixL();
  Random random(seed, kPriorStream);
  std::vector<ParameterVector> people(static_cast<std::size_t>(count));
  for (ParameterVector& person : people) {
    for (int attempt = 0; attempt < kTries; ++attempt) {
      person = drawOnce(prior, factor, random);
      if ((person >= 0.0 && person <= most).all()) break;
    }
    person = person.max(0.0).min(most);
  }
  return people;
}

}  // namespace cutis
