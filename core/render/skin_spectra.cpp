#include "core/render/skin_spectra.h"

#include <numeric>
#include <utility>
#include <vector>

namespace cutis {

Result<SkinSpectra> SkinSpectra::make(std::shared_ptr<const SkinModel> model,
                                      const PerPixel& perPixel, const JobContext& context) {
  SkinSpectra spectra(std::move(model), perPixel);
  if (perPixel.free.count() == 0) return spectra;
  std::vector<int> all(kSampleCount);
  std::iota(all.begin(), all.end(), 0);
  CUTIS_TRY(skin, FreeSkin::make(*spectra.model_, all, perPixel.free, context));
  spectra.skin_ = std::make_shared<const FreeSkin>(std::move(skin));
  return spectra;
}

Spectrum SkinSpectra::reflectance(const ParameterVector& parameters, const SkinConstants& constants,
                                  std::span<const double> coefficients) const {
  const Discrepancy* discrepancy = discrepancyOf(model_->profile(), perPixel_);
  if (discrepancy != nullptr && !coefficients.empty()) {
    return model_->reflectance(parameters) *
           discrepancy->factor(Eigen::Map<const Eigen::VectorXd>(
               coefficients.data(), static_cast<Eigen::Index>(coefficients.size())));
  }
  if (skin_ == nullptr) return model_->reflectance(parameters);
  const SkinConstants possible = skin_->coordinates().clamped(constants);
  const std::vector<double> values =
      skin_->evaluate({&parameters, 1}, {&possible, 1}, false).reflectance;
  return Eigen::Map<const Spectrum>(values.data());
}

}  // namespace cutis
