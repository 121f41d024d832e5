#include "core/skin/layer_optics.h"

#include "core/skin/absorption.h"
#include "core/skin/diffusion.h"

namespace cutis {
namespace {

// Multipole epidermis over dipole dermis. The air side is the only mismatched boundary.
class DiffusionOptics final : public LayerOptics {
 public:
  explicit DiffusionOptics(const Profile& profile)
      : epidermalScattering_(epidermalScattering(profile)),
        dermalScattering_(profile.dermalScatteringRatio * epidermalScattering_),
        thickness_(profile.epidermalThicknessMm),
        airFactor_(boundaryFactor(profile.refractiveIndex)) {}

  LayeredReflectance evaluate(int sample, double epidermal, double dermal) const override {
    const Dual below =
        halfSpaceReflectance(Dual(dermal, 1.0), dermalScattering_[sample], kMatchedFactor);
    const Dual overEpidermal =
        addedReflectance(slab(sample, Dual(epidermal, 1.0)), Dual(below.value));
    const Dual overDermal = addedReflectance(slab(sample, Dual(epidermal)), below);
    return {overEpidermal.value, overEpidermal.slope, overDermal.slope};
  }

  double reflectance(int sample, double epidermal, double dermal) const override {
    return addedReflectance(
        slab(sample, epidermal),
        halfSpaceReflectance(dermal, dermalScattering_[sample], kMatchedFactor));
  }

  bool holds(int sample, double epidermal, double dermal) const override {
    return epidermal <= epidermalScattering_[sample] && dermal <= dermalScattering_[sample];
  }

 private:
  static constexpr double kMatchedFactor = 1.0;

  template <typename Scalar>
  SlabOptics<Scalar> slab(int sample, const Scalar& absorption) const {
    return slabOptics(absorption, epidermalScattering_[sample], thickness_, airFactor_,
                      kMatchedFactor);
  }

  Spectrum epidermalScattering_;
  Spectrum dermalScattering_;
  double thickness_;
  double airFactor_;
};

}  // namespace

std::unique_ptr<const LayerOptics> makeLayerOptics(const Profile& profile) {
  switch (profile.layerOptics) {
    case LayerOpticsKind::diffusion:
      return std::make_unique<DiffusionOptics>(profile);
  }
  return nullptr;
}

}  // namespace cutis
