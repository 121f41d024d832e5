#pragma once

// Radiative transfer of a profile as a table: at every wavelength a polynomial of the two
// absorptions, fitted to adding–doubling (core/skin/layers/polynomial_fit.h).
//
// Reflectance is that of the light that enters and re-emerges, per flux that enters; absorptions in
// mm⁻¹, derivatives in mm. Covers, at each wavelength, the absorptions the profile's parameter box
// spans; beyond it by more than 2 % the nearest edge's value and slopes. Infinitely smooth inside.
//
// Error against direct adding–doubling over the box: below 1e-5 rms and 1e-4 at worst for
// thicknesses of 0.02 to 0.5 mm (see the tests). Why polynomials and no splines: all pixels share
// the 50 coefficients, so that the kernels neither gather nor branch, and evaluate in less time
// than diffusion's closed form.
//
// Thread-safe: const after construction. 0.17 MB for the whole grid.

#include <span>
#include <string>
#include <vector>

#include "core/base/job_context.h"
#include "core/skin/layers/polynomial_fit.h"
#include "core/skin/profile/profile.h"
#include "core/spectra/grid.h"

namespace cutis {

struct LayerTableOptions {
  int streams = 16;
  double anisotropy = 0.0;  // as in TransportOptions
  Illumination illumination = Illumination::collimated;
};

class LayerTable {
 public:
  // Makes it at the given positions on the wavelength grid, 2 ms each on one core; they run on all
  // cores and the bits do not depend on how many. Errors: those of fitLayerPolynomial, with the
  // wavelength as place. Precondition: samples lie on the grid.
  static Result<LayerTable> make(const Profile& profile, std::span<const int> samples,
                                 const LayerTableOptions& options = {},
                                 const JobContext& context = {});
  // The same at all 351 wavelengths.
  static Result<LayerTable> makeWhole(const Profile& profile, const LayerTableOptions& options = {},
                                      const JobContext& context = {});
  // Makes it from a copy of polynomials() that was kept, in the order of the samples. Precondition:
  // as many polynomials as samples.
  static LayerTable restore(std::span<const int> samples,
                            std::span<const LayerPolynomial<double>> polynomials);

  // Positions on the grid the table has, and a polynomial for each, in the same order.
  const std::vector<int>& samples() const { return samples_; }
  std::span<const LayerPolynomial<double>> polynomials() const { return polynomials_; }

  bool contains(int sample) const { return place_[sample] >= 0; }
  // Precondition: contains(sample).
  const LayerPolynomial<double>& at(int sample) const;

 private:
  LayerTable(std::span<const int> samples, std::vector<LayerPolynomial<double>> polynomials);

  std::vector<int> samples_;
  std::vector<LayerPolynomial<double>> polynomials_;
  Eigen::Array<int, kSampleCount, 1> place_;  // in polynomials_, or −1
};

// The two layers of a profile at one wavelength, with the absorptions its parameter box spans.
TwoLayers layersOf(const Profile& profile, int sample);
// The same at several, where what they share is worked out once.
std::vector<TwoLayers> layersOf(const Profile& profile, std::span<const int> samples);

// The polynomials of layers at these samples, one for each: what LayerTable::make does, for layers
// whose ranges are not those of the profile's own constants.
Result<std::vector<LayerPolynomial<double>>> fitLayers(const Profile& profile,
                                                       std::span<const int> samples,
                                                       std::span<const TwoLayers> layers,
                                                       const LayerTableOptions& options = {},
                                                       const JobContext& context = {});

// Names everything a table of a profile depends on, this form of the table included: equal
// fingerprints, equal tables.
std::string layerTableFingerprint(const Profile& profile, const LayerTableOptions& options = {});

}  // namespace cutis
