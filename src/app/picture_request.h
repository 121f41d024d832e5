#pragma once

// What picture of the skin is wanted: which light and eyes, or which band.

#include <optional>
#include <string>

#include "core/base/job_context.h"
#include "core/base/result.h"
#include "core/spectra/colorimetry.h"
#include "core/spectra/grid.h"

namespace cutis {

struct PictureRequest {
  // Names or paths, see src/files/spectral_library.h.
  std::string light = "D65";
  std::string observer = "cie1931";
  ChromaticAdaptation adaptation = ChromaticAdaptation::none;
  // Instead of a light and an observer: mean reflectance over a band, one channel.
  std::optional<Band> band;

  bool operator==(const PictureRequest&) const = default;
};

// A picture as rows of a response matrix: linear Rec.709 for an observer, the camera's own channels
// for a camera, one row for a band.
struct PictureRows {
  SpectrumRows rows;
  bool isColor = true;  // of an observer: in a colour space
};

// What stands in front of errors about the names.
struct PicturePlaces {
  std::string light = {};
  std::string observer = {};
};

// Reads each file that the request names once; `notice` hears what of it was left out.
Result<PictureRows> pictureRows(const PictureRequest& request, const PicturePlaces& places,
                                const Notice& notice = {});

// "uv" and "nir", or "A:B" in nm; both ends included. Fails with a sentence for anything else.
Result<Band> parseBand(const std::string& text, const std::string& place);

}  // namespace cutis
