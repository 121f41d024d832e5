#pragma once

// How a document is fitted: by which profile and method.

#include <string>

#include "core/base/result.h"
#include "core/fit/fit_options.h"
#include "src/app/open/source.h"
#include "src/files/profiles/profile_file.h"

namespace cutis {

struct FitChoice {
  std::string profile = kDefaultProfile;  // a built-in name or the path of a file
  FitMethod method = FitMethod::refined;
  // One more factor per pixel (core/fit/shading.h).
  bool shading = false;

  bool operator==(const FitChoice&) const = default;
};

// Shading is for photographs and the method refined; anything else is refused with a sentence.
Status checkFitChoice(const FitChoice& choice, const Source& source);

FitOptions fitOptions(const FitChoice& choice);

}  // namespace cutis
