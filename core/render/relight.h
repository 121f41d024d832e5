#pragma once

// Skin under a light: which rows of a response matrix a picture is.

#include "core/spectra/colorimetry.h"
#include "core/spectra/grid.h"

namespace cutis {

// Linear Rec.709 of skin under a light as an observer sees it: Y of a perfect diffuser is 1, so
// that under D65 it is (1, 1, 1). Without adaptation a reddish light gives a reddish picture; with
// it, the light's white becomes D65's. `daylight` is D65, for the white of Rec.709.
SpectrumRows colourRows(const Spectrum& light, const Sensor& observer,
                        ChromaticAdaptation adaptation, const Spectrum& daylight,
                        const Sensor& standardObserver);

// Mean reflectance over a band: flat light, flat sensor. Precondition: band.count() > 0.
SpectrumRows bandRow(const Band& band);

}  // namespace cutis
