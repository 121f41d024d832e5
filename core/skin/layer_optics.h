#pragma once

// The seam between the chemistry of skin and the transport of light: at one wavelength the whole
// two-layer reflectance depends on two numbers, the absorption of epidermis and of dermis.

#include <memory>

#include "core/skin/profile.h"
#include "core/spectra/grid.h"

namespace cutis {

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
  // Without derivatives.
  virtual double reflectance(int sample, double epidermalAbsorption,
                             double dermalAbsorption) const = 0;
  // Whether the theory holds there: for diffusion, scattering outweighs absorption (α' ≥ 0.5) in
  // both layers.
  virtual bool holds(int sample, double epidermalAbsorption, double dermalAbsorption) const = 0;
};

// Precondition: the profile is valid.
std::unique_ptr<const LayerOptics> makeLayerOptics(const Profile& profile);

}  // namespace cutis
