#pragma once

// Spectral nodes of a skin model, for whatever is asked of it: channels of a rig, XYZ under a
// light, a UV band.

#include "core/skin/model/skin_model.h"
#include "core/spectra/spectral_nodes.h"

namespace cutis {

// Samples the profile's whole parameter box. Deterministic; about 50 ms, and at once when the model
// was asked for the same before.
SpectralNodes chooseNodes(const SkinModel& model, const SpectrumRows& rows,
                          const NodeOptions& options = {});

}  // namespace cutis
