#pragma once  // internal to core/neural/dense

// One step of Adam (Kingma & Ba 2015, algorithm 1) with decoupled weight decay.

#include <cstddef>
#include <cstdint>

namespace cutis {

struct AdamStep {
  std::int64_t step = 1;  // the first is 1
  double rate = 0.0;
  double weightDecay = 0.0;
};

// Arrays of `count` numbers: weights and both moments change.
void adamUpdate(const AdamStep& step, const float* gradient, std::size_t count, float* firstMoment,
                float* secondMoment, float* weights);

}  // namespace cutis
