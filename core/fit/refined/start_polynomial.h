#pragma once  // internal to core/fit/refined

// Where the refined fit begins: a polynomial of the fourth degree in the leading principal
// components of a pixel's log channels, one for darker and one for lighter skin, least squares over
// simulated noisy pixels of the prior. A part of the pixels is from a wider prior: where it has
// seen next to nobody, a polynomial runs away, and the fit with it.
//
// Its target is the estimate itself: pixels are solved from a first polynomial, which was made for
// the true parameters, and a second one is made for what came out. So the start is about as good as
// the data allow, and one or two Gauss–Newton steps finish it.

#include <array>
#include <functional>
#include <optional>

#include "core/base/pixel_rows.h"
#include "core/fit/refined/channel_discrepancy.h"
#include "core/fit/refined/refined_kernel.h"
#include "core/rig/rig.h"
#include "core/skin/model/skin_model.h"
#include "core/skin/profile/prior.h"
#include "core/spectra/spectral_nodes.h"

namespace cutis {

// Solves pixels from a start: channels in, coordinates out.
using StartTrial = std::function<void(const StartPolynomial& start, PixelRows<const float> channels,
                                      PixelRows<float> coordinates)>;

// What pixels there may be.
struct StartScene {
  const SkinModel& model;
  const SpectralNodes& nodes;  // of the rig's channels
  const Prior& prior;
  const NoiseModel& noise;
  const std::array<std::optional<double>, kParameterCount>& fixed;  // drawn at their value
  double shadingDeviation = 0.0;  // of a factor on all channels of a pixel; 0: there is none
  const ChannelDiscrepancy& discrepancy;  // drawn with the people; may be empty
};

// Deterministic on one instruction set; about 60 ms.
StartPolynomial trainStartPolynomial(const StartScene& scene, const StartTrial& solve);

}  // namespace cutis
