#pragma once  // internal to core/fit/refined

// The exact setting: what the single precision found, taken to full convergence in double precision
// with next to no noise assumed. Needs as many channels as there are parameters to find.
//
// Pixels whose channels no skin meets, because there is noise in them after all, can be led astray
// on the way: the steps in single precision are long and the valley narrow. Those are tried again
// from where a fit that does assume noise ends, and keep the better of both. Thread-safe: const
// after construction.

#include <cstdint>

#include "core/base/pixel_rows.h"
#include "core/fit/refined/fast_pass.h"

namespace cutis {

class ExactPass {
 public:
  // noise: what is assumed, next to none.
  ExactPass(const SkinModel& model, const SpectralNodes& nodes, const Prior& prior,
            const NoiseModel& noise, const FitOptions& options,
            const ChannelDiscrepancy& discrepancy = {});

  // Coordinates in and out, coefficients out unless there are none. Adds to rounds.
  void finish(PixelRows<const float> channels, PixelRows<float> coordinates,
              PixelRows<float> coefficients, std::uint16_t* rounds, std::uint8_t* converged) const;

 private:
  struct Ends;
  void retry(PixelRows<const float> channels, Ends& ends, PixelRows<float> coefficients,
             std::uint16_t* rounds, std::uint8_t* converged) const;

  RefinedProblemData<double> exact_;
  FastPass cautious_;
};

}  // namespace cutis
