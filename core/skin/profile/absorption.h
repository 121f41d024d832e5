#pragma once

// Absorption of the two layers as linear forms of the parameters (paper, eq. 1 and 2), and the
// chain rule that goes with them. mm⁻¹.
//
//   epidermis: σ_a = base + C_m [β_m · eumelanin + (1 − β_m) · pheomelanin] + Σ C · absorption
//   dermis:    σ_a = base                                                   + Σ C · absorption
//
// where the sums run over the other rows of the table of chromophores that lie in the layer
// (core/skin/profile/chromophore_table.h; blood and carotene, then a profile's further ones), and
// base is the layer's tissue and water, and the dermis's fat. Each chromophore displaces tissue;
// the coefficients here are net of that and may be negative where a chromophore absorbs less than
// the tissue it displaces.
//
// Thread-safe: const after construction, and pure functions.

#include <array>
#include <cassert>
#include <cstddef>
#include <span>
#include <vector>

#include "core/skin/profile/chromophore_table.h"
#include "core/skin/profile/parameter_axis.h"
#include "core/skin/profile/profile.h"
#include "core/spectra/grid.h"

namespace cutis {

// A number of each layer: their absorptions, or the derivatives by these.
struct LayerPair {
  double epidermal = 0.0;
  double dermal = 0.0;

  double& of(SkinLayer layer) { return layer == SkinLayer::epidermis ? epidermal : dermal; }
  double of(SkinLayer layer) const { return layer == SkinLayer::epidermis ? epidermal : dermal; }
};

// Parameters are in the order of the profile's (parameterCount()); of a set that ends after the
// five the further amounts are 0.
class AbsorptionLaw {
 public:
  // Precondition: further chromophores have an absorption.
  explicit AbsorptionLaw(const Profile& profile);

  int parameterCount() const { return static_cast<int>(layers_.size()); }
  SkinLayer layerOf(int parameter) const { return layers_[static_cast<std::size_t>(parameter)]; }
  // The absorption of the layer without chromophores, and that of a unit of a row of the table.
  double base(SkinLayer layer, int sample) const;
  double perUnit(int parameter, int sample) const { return ofRows(sample)[parameter]; }

  LayerPair at(int sample, std::span<const double> parameters) const;
  LayerPair at(int sample, const ParameterVector& parameters) const {
    return at(sample, asSpan(parameters));
  }

  // From the derivatives of anything by the two absorptions to those by the parameters, as many as
  // there are `parameters`.
  void byParameters(int sample, std::span<const double> parameters, const LayerPair& byAbsorption,
                    double* derivatives) const;

 private:
  static constexpr std::size_t kBases = 2;  // of the layers, before the rows

  const double* ofSample(int sample) const {
    return coefficients_.data() + static_cast<std::size_t>(sample) * (kBases + layers_.size());
  }
  const double* ofRows(int sample) const { return ofSample(sample) + kBases; }

  std::vector<SkinLayer> layers_;     // of the rows
  std::vector<double> coefficients_;  // [sample][base of the epidermis, of the dermis, rows]
};

// Absorption of a layer without chromophores; of the tissue alone that chromophores displace; and
// the water's share of the volume.
Spectrum baseIn(const Profile& profile, SkinLayer layer);
Spectrum tissueIn(const Profile& profile, SkinLayer layer);
double waterIn(const Profile& profile, SkinLayer layer);

// Absorption of undiluted blood as it lies in a layer.
Spectrum bloodIn(const Profile& profile, const BloodOptics& layer);

// (1 − e^(−2qr)) / (2qr) for absorption q (≥ 0) in vessels of radius r (≥ 0): 1 where either is 0.
double packagingFactor(double absorptionPerMm, double radiusMm);

// Reduced scattering; paper, eq. 6 for the epidermis.
Spectrum epidermalScattering(const Profile& profile);
Spectrum dermalScattering(const Profile& profile);

// The longest transport mean free path in an epidermis without chromophores, 300 to 1000 nm: the
// thinnest slab that diffusion describes.
double longestPathMm(const Profile& profile);

// The loops of many skins at many wavelengths stand on these two.

inline LayerPair AbsorptionLaw::at(int sample, std::span<const double> parameters) const {
  assert(parameters.size() <= layers_.size());
  const double* bases = ofSample(sample);
  const double* rows = bases + kBases;
  const double blend = parameters[kMelaninBlend];
  LayerPair sums = {bases[0], bases[1]};
  sums.epidermal +=
      parameters[kMelanin] * (blend * rows[kMelanin] + (1.0 - blend) * rows[kMelaninBlend]);
  for (std::size_t k = kMelaninBlend + 1; k < parameters.size(); ++k)
    sums.of(layers_[k]) += parameters[k] * rows[k];
  return sums;
}

inline void AbsorptionLaw::byParameters(int sample, std::span<const double> parameters,
                                        const LayerPair& byAbsorption, double* derivatives) const {
  const double* rows = ofRows(sample);
  const double eumelanin = rows[kMelanin], pheomelanin = rows[kMelaninBlend];
  const double blend = parameters[kMelaninBlend];
  const double byEpidermal = byAbsorption.epidermal;
  derivatives[kMelanin] = byEpidermal * (blend * eumelanin + (1.0 - blend) * pheomelanin);
  derivatives[kMelaninBlend] = byEpidermal * parameters[kMelanin] * (eumelanin - pheomelanin);
  for (std::size_t k = kMelaninBlend + 1; k < parameters.size(); ++k)
    derivatives[k] = byAbsorption.of(layers_[k]) * rows[k];
}

}  // namespace cutis
