#include "core/fit/population.h"

#include <cstddef>

#include "core/base/random.h"

namespace cutis {

ParameterBox protocolPopulation() {
  return {{0.01, 0.2, 0.005, 0.0, 0.0}, {0.25, 1.0, 0.1, 0.05, 0.004}};
}

std::vector<ParameterVector> drawPopulation(const ParameterBox& box, int count,
                                            unsigned long long seed) {
  Random random(seed);
  std::vector<ParameterVector> people(static_cast<std::size_t>(count));
  for (ParameterVector& p : people) {
    for (int k = 0; k < kParameterCount; ++k) p[k] = random.uniform(box.low[k], box.high[k]);
  }
  return people;
}

}  // namespace cutis
