#pragma once

// Everything that is known of one pixel, for a panel that inspects it.
//
// Thread-safe: a pure function.

#include <array>
#include <optional>
#include <string>
#include <vector>

#include <Eigen/Core>

#include "core/analyse/skin_indices.h"
#include "core/base/job_context.h"
#include "core/base/result.h"
#include "core/skin/profile/parameter.h"
#include "src/app/document/place_spectra.h"
#include "src/app/document/scene.h"
#include "src/app/open/fit_choice.h"
#include "src/app/project/pin.h"

namespace cutis {

struct InspectedPlace {
  int x = 0;
  int y = 0;
  // What stands in the file, channel by channel and as it is encoded there: of an image all its
  // channels, of photographs the linear ones of every light. Empty for maps by themselves.
  struct SourceValue {
    std::string name;
    double value = 0.0;
  };
  std::vector<SourceValue> source;
  // The photograph as linear Rec.709 under D65, without the exposure; none without one.
  std::optional<Eigen::Vector3d> linear;
  // The following are of pixels with an estimate.
  std::optional<PlaceSpectra> skin;
  SkinIndices original;
  SkinIndices edited;
  // Whether the photographs say little about a parameter (core/analyse/doubtful_value.h).
  std::array<bool, kParameterCount> isMostlyPrior = {};
  // CIEDE2000 under D65, CIE 1931: of the skin model to the photograph, with the exposure, and of
  // the edited skin here to that at the reference pin. None without a photograph or a reference.
  std::optional<double> reconstructionDifference;
  std::optional<double> referenceDifference;
};

// Precondition: the pixel lies in the picture. About a millisecond; errors are those of planes that
// cannot be read.
Result<InspectedPlace> inspectPlace(const Scene& scene, const FitChoice& choice, const PinSet& pins,
                                    int x, int y);

}  // namespace cutis
