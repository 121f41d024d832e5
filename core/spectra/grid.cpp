#include "core/spectra/grid.h"

#include <algorithm>
#include <cmath>

namespace cutis {

Band bandBetween(double fromNm, double toNm) {
  const auto first = std::ceil((fromNm - kFirstWavelengthNm) / kWavelengthStepNm);
  const auto last = std::floor((toNm - kFirstWavelengthNm) / kWavelengthStepNm);
  return {static_cast<int>(std::clamp(first, 0.0, double{kSampleCount})),
          static_cast<int>(std::clamp(last, -1.0, double{kSampleCount - 1}))};
}

}  // namespace cutis
