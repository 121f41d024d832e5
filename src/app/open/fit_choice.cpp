#include "src/app/open/fit_choice.h"

#include "core/fit/shading.h"

namespace cutis {

Status checkFitChoice(const FitChoice& choice, const Source& source) {
  if (!choice.shading) return {};
  if (choice.method != FitMethod::refined) {
    return usageError("Shading",
                      "only the method refined can estimate it; choose that, or leave "
                      "shading out");
  }
  if (source.image) {
    return usageError("Shading",
                      "a texture is taken as albedo without shades; open photographs "
                      "under several lights to estimate it");
  }
  return {};
}

FitOptions fitOptions(const FitChoice& choice) {
  FitOptions options;
  options.method = choice.method;
  if (choice.shading) options.shading = kUsualShadingDeviation;
  return options;
}

}  // namespace cutis
