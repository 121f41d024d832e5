#pragma once

// How a document is fitted: by which profile and method.

#include <array>
#include <optional>
#include <string>

#include "core/base/result.h"
#include "core/fit/fit_options.h"
#include "src/app/open/source.h"
#include "src/files/profiles/profile_file.h"

namespace cutis {

// More is no skin.
inline constexpr double kMostSpecularShare = 0.5;

struct FitChoice {
  std::string profile = kDefaultProfile;  // a built-in name or the path of a file
  FitMethod method = FitMethod::refined;
  // One more factor per pixel (core/fit/shading.h).
  bool shading = false;
  // A factor on a single image's linear values; found anew by each fit unless given.
  std::optional<double> exposure = {};
  // What has become of the reflection at the skin's surface in photographs, and, where they contain
  // it, how large it is; it is taken off them then. None: nobody has said.
  std::optional<SpecularPart> specular = {};
  double specularShare = kSkinSpecularShare;

  // For the method refined alone, here and below; see core/fit/fit_options.h.
  // Standard deviations, constant and proportional; the rig's unless given.
  std::optional<std::array<double, 2>> noise = {};
  std::string prior = {};  // the path of a file; empty: the profile's
  std::array<std::optional<double>, kParameterCount> fixed = {};
  FreeConstants free = {};
  std::optional<bool> discrepancy = {};

  bool operator==(const FitChoice&) const = default;
  // Whether anything is chosen that only the method refined knows, shading aside.
  bool hasRefinements() const;
};

// What is taken off photographs of skin of the profile.
MeasurementGeometry surfaceOf(const FitChoice& choice, const Profile& profile);

// Whether the source has to be read again for a fit as `next` after one as `now`.
bool needsReading(const FitChoice& now, const FitChoice& next);

// The source at the exposure that was chosen, or as it is.
std::shared_ptr<const Source> atChosenExposure(const std::shared_ptr<const Source>& source,
                                               const FitChoice& choice);

// Shading is for photographs without reflection of the surface; it and the refinements are for the
// method refined, and they do not all go together. Anything else is refused with a sentence.
Status checkFitChoice(const FitChoice& choice, const Source& source);

// Reads the prior's file; the profile is the choice's, and what it does not allow is refused.
Result<FitOptions> fitOptions(const FitChoice& choice, const Profile& profile);

}  // namespace cutis
