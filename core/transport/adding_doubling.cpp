#include "core/transport/adding_doubling.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

#include "core/transport/adding.h"

namespace cutis {
namespace {

bool isAmount(double value) {
  return std::isfinite(value) && value >= 0.0;
}

Status checkOptions(const TransportOptions& options) {
  const int n = options.streams;
  if (n != 16 && n != 32) {
    return inputError("", "the number of streams must be 16 or 32");
  }
  if (!(options.refractiveIndex >= 1.0 && options.refractiveIndex <= 3.0)) {
    return inputError("", "the refractive index must lie between 1 and 3");
  }
  if (!(std::abs(options.anisotropy) <= 0.95)) {
    return inputError("", "the anisotropy g must lie between -0.95 and 0.95");
  }
  return {};
}

Status checkLayer(const TransportLayer& layer, bool last) {
  if (!isAmount(layer.absorption) || !isAmount(layer.reducedScattering)) {
    return inputError("", "absorption and scattering must be finite and not negative");
  }
  if (!(layer.thickness >= 0.0)) return inputError("", "the thickness must not be negative");
  if (std::isinf(layer.thickness)) {
    if (!last) return inputError("", "only the last layer may be semi-infinite");
    if (layer.absorption + layer.reducedScattering == 0.0) {
      return inputError("", "a semi-infinite layer must absorb or scatter");
    }
  }
  return {};
}

Status checkLayers(std::span<const TransportLayer> layers) {
  if (layers.empty()) return inputError("", "at least one layer is needed");
  for (std::size_t i = 0; i < layers.size(); ++i) {
    CUTIS_CHECK(checkLayer(layers[i], i + 1 == layers.size()));
  }
  return {};
}

template <int N>
LitInterface<N> belowLayer(const Streams<N>& streams, const LitInterface<N>& above,
                           const TransportLayer& layer, double anisotropy) {
  const double depth = opticalDepth(layer, anisotropy);
  if (depth == 0.0) return above;
  return below(above, layerAdmittance(equationOf(streams, layer, anisotropy), depth));
}

template <int N>
StreamMatrix<N> halfSpace(const Streams<N>& streams, const TransportLayer& layer,
                          double anisotropy) {
  return halfSpaceAdmittance(equationOf(streams, layer, anisotropy));
}

// Rounding may leave a black layer a hair below zero.
template <int N>
double reflectanceOver(const LitInterface<N>& interface, const StreamVector<N>& light) {
  return std::max(0.0, interface.reflectance + interface.collector.dot(light));
}

template <int N>
TransportResult transportThrough(std::span<const TransportLayer> layers,
                                 const TransportOptions& options) {
  const Streams<N> streams = makeStreams<N>(options.refractiveIndex);
  LitInterface<N> interface = litSurface(streams, options.illumination);
  const bool open = std::isfinite(layers.back().thickness);
  const std::size_t slabs = layers.size() - (open ? 0 : 1);
  for (const TransportLayer& layer : layers.first(slabs)) {
    interface = belowLayer(streams, interface, layer, options.anisotropy);
  }
  StreamMatrix<N> end = streams.surface.asDiagonal();
  if (!open) end = halfSpace(streams, layers.back(), options.anisotropy);
  const StreamVector<N> light = lightOver(interface, end);
  TransportResult result;
  result.reflectance = reflectanceOver(interface, light);
  if (open) result.transmittance = streams.fluxRoot.dot(streams.surface.cwiseProduct(light));
  result.specular = specularShare(streams, options.refractiveIndex, options.illumination);
  return result;
}

template <int N>
Eigen::ArrayXXd gridReflectances(const TwoLayerGrid& grid, const TransportOptions& options) {
  const Streams<N> streams = makeStreams<N>(options.refractiveIndex);
  const LitInterface<N> surface = litSurface(streams, options.illumination);
  std::vector<StreamMatrix<N>> dermis;
  for (const double absorption : grid.dermalAbsorptions) {
    dermis.push_back(halfSpace(streams, {absorption, grid.dermalScattering}, options.anisotropy));
  }
  Eigen::ArrayXXd reflectances(static_cast<Eigen::Index>(grid.epidermalAbsorptions.size()),
                               static_cast<Eigen::Index>(grid.dermalAbsorptions.size()));
  for (std::size_t row = 0; row < grid.epidermalAbsorptions.size(); ++row) {
    const TransportLayer epidermis = {grid.epidermalAbsorptions[row], grid.epidermalScattering,
                                      grid.thickness};
    const LitInterface<N> interface = belowLayer(streams, surface, epidermis, options.anisotropy);
    for (std::size_t column = 0; column < dermis.size(); ++column) {
      reflectances(static_cast<Eigen::Index>(row), static_cast<Eigen::Index>(column)) =
          reflectanceOver(interface, lightOver(interface, dermis[column]));
    }
  }
  return reflectances;
}

Status checkGrid(const TwoLayerGrid& grid) {
  if (!std::isfinite(grid.thickness)) {
    return inputError("", "the epidermis must be of finite thickness");
  }
  for (const double absorption : grid.epidermalAbsorptions) {
    CUTIS_CHECK(checkLayer({absorption, grid.epidermalScattering, grid.thickness}, false));
  }
  for (const double absorption : grid.dermalAbsorptions) {
    CUTIS_CHECK(checkLayer({absorption, grid.dermalScattering}, true));
  }
  return {};
}

}  // namespace

Result<TransportResult> layeredTransport(std::span<const TransportLayer> layers,
                                         const TransportOptions& options) {
  CUTIS_CHECK(checkOptions(options));
  CUTIS_CHECK(checkLayers(layers));
  if (options.streams == 16) return transportThrough<16>(layers, options);
  return transportThrough<32>(layers, options);
}

Result<Eigen::ArrayXXd> twoLayerReflectances(const TwoLayerGrid& grid,
                                             const TransportOptions& options) {
  CUTIS_CHECK(checkOptions(options));
  CUTIS_CHECK(checkGrid(grid));
  if (options.streams == 16) return gridReflectances<16>(grid, options);
  return gridReflectances<32>(grid, options);
}

}  // namespace cutis
