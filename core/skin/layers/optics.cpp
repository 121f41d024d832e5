#include "core/skin/layers/optics.h"

#include <utility>

#include "core/skin/layers/polynomial_fit.h"
#include "core/skin/layers/table.h"
#include "core/skin/profile/absorption.h"
#include "core/transport/diffusion.h"

namespace cutis {
namespace {

// Multipole epidermis over dipole dermis. The air side is the only mismatched boundary.
class DiffusionOptics final : public LayerOptics {
 public:
  explicit DiffusionOptics(const Profile& profile)
      : epidermalScattering_(epidermalScattering(profile)),
        dermalScattering_(dermalScattering(profile)),
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

  const LayerPolynomial<double>* polynomialAt(int) const override { return nullptr; }

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

// Adding–doubling, fitted beforehand.
class TabulatedOptics final : public LayerOptics {
 public:
  explicit TabulatedOptics(std::shared_ptr<const LayerTable> table) : table_(std::move(table)) {}

  LayeredReflectance evaluate(int sample, double epidermal, double dermal) const override {
    return cutis::evaluate(table_->at(sample), epidermal, dermal);
  }
  double reflectance(int sample, double epidermal, double dermal) const override {
    return evaluate(sample, epidermal, dermal).reflectance;
  }
  bool holds(int, double, double) const override { return true; }
  const LayerPolynomial<double>* polynomialAt(int sample) const override {
    return &table_->at(sample);
  }

 private:
  std::shared_ptr<const LayerTable> table_;
};

}  // namespace

std::unique_ptr<const LayerOptics> makeDiffusionOptics(const Profile& profile) {
  return std::make_unique<DiffusionOptics>(profile);
}

std::unique_ptr<const LayerOptics> makeTabulatedOptics(std::shared_ptr<const LayerTable> table) {
  return std::make_unique<TabulatedOptics>(std::move(table));
}

}  // namespace cutis
