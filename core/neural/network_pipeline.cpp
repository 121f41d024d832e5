#include "core/neural/network_pipeline.h"

#include <algorithm>
#include <cassert>

#include "core/neural/dense/aligned_floats.h"

namespace cutis {
namespace {

// Moving a network leaves its arrays where they are, so these survive a move of the pipeline.
std::vector<DenseKernelLayer> kernelLayers(const DenseNetwork& network) {
  std::vector<DenseKernelLayer> layers;
  for (const DenseLayer& layer : network.layers)
    layers.push_back(kernelLayer(layer));
  return layers;
}

std::size_t widestOf(const std::vector<DenseKernelLayer>& layers, std::size_t widest) {
  for (const DenseKernelLayer& layer : layers)
    widest = std::max({widest, layer.inputs, layer.outputs});
  return widest;
}

// Coordinates → rows: SpectraNN, then rows · (mean + components · weights).
DenseNetwork withRows(const SpectraNetwork& spectra, const SpectrumRows& rows) {
  DenseNetwork network = spectra.network;
  network.layers.push_back(
      linearLayer(rows.matrix() * spectra.components, rows.matrix() * spectra.mean.matrix()));
  return merged(network);
}

}  // namespace

NetworkPipeline::NetworkPipeline(const DenseNetwork* encoder, const DenseNetwork* decoder,
                                 const ParameterAxes& axes) {
  if (encoder != nullptr) encoder_ = *encoder;
  if (decoder != nullptr) decoder_ = *decoder;
  encoderLayers_ = kernelLayers(encoder_);
  decoderLayers_ = kernelLayers(decoder_);
  for (std::size_t k = 0; k < axes.size(); ++k) {
    pass_.axes[k] = {static_cast<float>(axes[k].maximum), static_cast<float>(1.0 / axes[k].maximum),
                     axes[k].exponent};
  }
  pass_.smallestChannel = static_cast<float>(kSmallestNetworkChannel);
  pass_.inputCount = encoder != nullptr ? encoderLayers_.front().inputs
                                        : static_cast<std::size_t>(kParameterCount);
  pass_.outputCount = decoder != nullptr ? decoderLayers_.back().outputs : 0;
  pass_.widest = widestOf(decoderLayers_, widestOf(encoderLayers_, pass_.inputCount));
}

NetworkPipeline NetworkPipeline::encoder(const ChromophoreNetwork& chromophores) {
  const DenseNetwork network = merged(chromophores.network);
  return {&network, nullptr, chromophores.axes};
}

NetworkPipeline NetworkPipeline::decoder(const SpectraNetwork& spectra, const SpectrumRows& rows) {
  const DenseNetwork network = withRows(spectra, rows);
  return {nullptr, &network, spectra.axes};
}

Result<NetworkPipeline> NetworkPipeline::encoderDecoder(const ChromophoreNetwork& chromophores,
                                                        const SpectraNetwork& spectra,
                                                        const SpectrumRows& rows) {
  if (!alike(chromophores.profile, spectra.profile)) {
    return inputError("",
                      "ChromNN and SpectraNN were trained for different profiles; train one of "
                      "them again");
  }
  const DenseNetwork front = merged(chromophores.network);
  const DenseNetwork back = withRows(spectra, rows);
  return NetworkPipeline(&front, &back, spectra.axes);
}

std::size_t NetworkPipeline::workPerPixel() const {
  return (encoder_.layers.empty() ? 0 : encoder_.workPerSample()) +
         (decoder_.layers.empty() ? 0 : decoder_.workPerSample());
}

void NetworkPipeline::run(PixelRows<const float> inputs, PixelRows<float> parameters,
                          PixelRows<float> outputs) const {
  assert(inputs.rowCount == pass_.inputCount);
  assert(parameters.rowCount == 0 || parameters.rowCount == std::size_t{kParameterCount});
  assert(outputs.rowCount == pass_.outputCount);
  NetworkPass pass = pass_;
  pass.encoder = encoderLayers_.data();
  pass.encoderLayers = encoderLayers_.size();
  pass.decoder = decoderLayers_.data();
  pass.decoderLayers = decoderLayers_.size();
  AlignedFloats scratch(networkScratchSize(pass));
  runNetworkKernel(pass, inputs, parameters, outputs, scratch.data());
}

}  // namespace cutis
