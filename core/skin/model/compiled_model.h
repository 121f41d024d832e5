#pragma once

// The skin model compiled for a few wavelengths ("nodes"): what the vectorised kernels read.
//
// Everything a picture needs is a weighted sum of reflectances at some dozen nodes (see
// core/spectra/spectral_nodes.h), so this is where the program spends its time. Single precision
// for pixels, double where a result must be exact. The kernels know the five parameters and no
// further chromophores (core/skin/profile/chromophore_table.h).

#include <memory>
#include <vector>

#include "core/skin/layers/node_constants.h"
#include "core/skin/model/skin_model.h"

namespace cutis {

class CompiledModel {
 public:
  // samples: positions on the wavelength grid, in the order of the nodes. Precondition: the profile
  // has no further chromophores (requireFive()).
  CompiledModel(const SkinModel& model, std::vector<int> samples);

  int nodeCount() const { return static_cast<int>(samples_.size()); }
  const std::vector<int>& samples() const { return samples_; }

  // T is float or double.
  template <typename T>
  const std::vector<NodeConstants<T>>& nodes() const;
  template <typename T>
  const LayerConstants<T>& layers() const;

 private:
  std::vector<int> samples_;
  std::vector<NodeConstants<float>> singleNodes_;
  std::vector<NodeConstants<double>> doubleNodes_;
  // What the nodes point to; copies of the model share it. Empty for diffusion.
  std::shared_ptr<const std::vector<LayerPolynomial<float>>> singleTransport_;
  std::shared_ptr<const std::vector<LayerPolynomial<double>>> doubleTransport_;
  LayerConstants<float> singleLayers_;
  LayerConstants<double> doubleLayers_;
};

}  // namespace cutis
