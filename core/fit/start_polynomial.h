#pragma once

// Where the refined fit begins: a cubic polynomial in the leading principal components of a pixel's
// log channels, least squares over simulated noisy pixels of the prior.
//
// Regression on noisy pixels estimates the posterior mean, so the start is already about as good as
// the data allow and two Gauss–Newton steps finish it.

#include <array>
#include <optional>

#include "core/fit/refined_kernel.h"
#include "core/rig/rig.h"
#include "core/skin/prior.h"
#include "core/skin/skin_model.h"
#include "core/spectra/spectral_nodes.h"

namespace cutis {

// nodes: of the rig's channels. Fixed parameters are drawn at their value. Deterministic; about 30 ms.
StartPolynomial trainStartPolynomial(const SkinModel& model, const SpectralNodes& nodes,
                                     const Prior& prior, const NoiseModel& noise,
                                     const std::array<std::optional<double>, kParameterCount>& fixed);

}  // namespace cutis
