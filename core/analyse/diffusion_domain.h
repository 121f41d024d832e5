#pragma once

// How much of a picture lies outside the domain of its profile's theory of light.
//
// Diffusion holds where scattering outweighs absorption (α' ≥ 0.5, core/skin/layers/optics.h);
// where it does not, it reads skin too bright. A pixel is outside if one of its layers is at some
// wavelength of the visible range. Radiative transfer holds everywhere.
//
// Looked at is a regular sample of the pixels with an estimate, at most about 16,000 and all of a
// small picture, at every 10 nm from 400 to 700. Deterministic; a fraction of a second.

#include <optional>

#include "core/base/job_context.h"
#include "core/base/result.h"
#include "core/skin/chromophore_maps.h"
#include "core/skin/profile/profile.h"

namespace cutis {

// Above this share a person should hear of it.
inline constexpr double kNoticeableOutside = 0.05;

// The share of the pixels that are outside, 0 to 1; none for a profile by radiative transfer, or
// where no pixel has an estimate. Constants of the maps count in place of the profile's. Errors: of
// reading the maps. Precondition: the profile is valid and has no further chromophores.
Result<std::optional<double>> shareOutsideDiffusion(const ChromophoreMaps& maps,
                                                    const Profile& profile,
                                                    const JobContext& context);

}  // namespace cutis
