#pragma once

// One interface for all methods: channels of a batch of pixels in, parameters out.

#include <cstddef>
#include <cstdint>
#include <span>

#include "core/base/job_context.h"
#include "core/base/result.h"

namespace cutis {

// Arrays hold one row of `stride` floats per channel or parameter; the first `count` count.
struct SolveBatch {
  std::size_t count = 0;
  std::size_t stride = 0;
  const float* channels = nullptr;    // in: [channel][stride], finite and not negative
  float* parameters = nullptr;        // out: [parameter][stride], in the parameters' units
  std::uint8_t* states = nullptr;     // out: PixelState, solved or noConvergence
  std::uint16_t* iterations = nullptr;  // out: 0 for a search
  float* deviations = nullptr;        // out: [parameter][stride], posterior standard deviations;
                                      // null: not wanted
  float* residuals = nullptr;         // out: [channel][stride], measured minus modelled; null: not
                                      // wanted
};

// Thread-safe: const after construction. A pixel's result is a function of its own channels alone,
// whatever stands beside it in the batch.
class PixelSolver {
 public:
  virtual ~PixelSolver() = default;

  virtual void solve(const SolveBatch& batch) const = 0;
  // What the interface calls its work, e.g. "refined fit".
  virtual const char* stage() const = 0;
  // Wavelengths at which the model is evaluated per iteration; 0 for a search.
  virtual int nodeCount() const { return 0; }
  virtual bool hasDeviations() const { return false; }
};

}  // namespace cutis
