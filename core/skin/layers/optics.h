#pragma once

// The seam between the chemistry of skin and the transport of light: at one wavelength the whole
// two-layer reflectance depends on two numbers, the absorption of epidermis and of dermis.

#include <memory>

#include "core/skin/layers/polynomial.h"
#include "core/skin/profile/profile.h"
#include "core/spectra/grid.h"

namespace cutis {

class LayerTable;

// Diffuse reflectance and its derivatives with respect to both absorptions (mm).
struct LayeredReflectance {
  double reflectance = 0.0;
  double perEpidermalAbsorption = 0.0;
  double perDermalAbsorption = 0.0;
};

// Thread-safe: const after construction.
class LayerOptics {
 public:
  virtual ~LayerOptics() = default;

  // Absorptions in mm⁻¹, finite and not negative.
  virtual LayeredReflectance evaluate(int sample, double epidermalAbsorption,
                                      double dermalAbsorption) const = 0;
  // The same without derivatives.
  virtual double reflectance(int sample, double epidermalAbsorption,
                             double dermalAbsorption) const = 0;
  // Whether the theory holds there: for diffusion, scattering outweighs absorption (α' ≥ 0.5) in
  // both layers; radiative transfer does everywhere.
  virtual bool holds(int sample, double epidermalAbsorption, double dermalAbsorption) const = 0;
  // The polynomial of both absorptions that it is at this sample; null if it is none.
  virtual const LayerPolynomial<double>* polynomialAt(int sample) const = 0;
};

// The optics of layerOptics = diffusion. Precondition: the profile is valid.
std::unique_ptr<const LayerOptics> makeDiffusionOptics(const Profile& profile);

// Radiative transfer, from a table of it. Precondition: the table has the whole grid.
std::unique_ptr<const LayerOptics> makeTabulatedOptics(std::shared_ptr<const LayerTable> table);

}  // namespace cutis
