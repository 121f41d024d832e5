#pragma once

// Pictures through the networks: channels → parameters, parameters → rows of a response matrix, or
// both in one pass.
//
// Where rows are asked for, the last layer of SpectraNN, the components and the rows become one
// matrix: a channel under any light costs as much as one more output, and the 351 samples arise
// nowhere (unless they are the rows: an identity matrix gives whole spectra).
//
// Thread-safe: const after construction; callers divide a picture among threads. A result depends
// on its own pixel alone: any division gives the same bits (on one instruction set). An input that
// is NaN or infinite makes all outputs of its pixel NaN. Channels below kSmallestNetworkChannel
// count as that; parameters outside the axes as the nearest value inside. Against evaluate() of the
// same networks in double precision, rows and coordinates are within 2e-5.

#include <vector>

#include "core/base/pixel_rows.h"
#include "core/neural/chromophore_network.h"
#include "core/neural/network_kernel.h"
#include "core/neural/spectra_network.h"

namespace cutis {

class NetworkPipeline {
 public:
  // Channels → parameters. Precondition, here and below: the networks passed validate().
  static NetworkPipeline encoder(const ChromophoreNetwork& chromophores);
  // Parameters → rows.
  static NetworkPipeline decoder(const SpectraNetwork& spectra, const SpectrumRows& rows);
  // Channels → parameters → rows. Fails if the two belong to different profiles.
  static Result<NetworkPipeline> encoderDecoder(const ChromophoreNetwork& chromophores,
                                                const SpectraNetwork& spectra,
                                                const SpectrumRows& rows);

  NetworkPipeline(NetworkPipeline&&) = default;
  NetworkPipeline& operator=(NetworkPipeline&&) = default;
  NetworkPipeline(const NetworkPipeline&) = delete;
  NetworkPipeline& operator=(const NetworkPipeline&) = delete;

  int inputCount() const { return static_cast<int>(pass_.inputCount); }
  int outputCount() const { return static_cast<int>(pass_.outputCount); }
  // Multiply-adds per pixel.
  std::size_t workPerPixel() const;

  // inputs: a row per channel, or per parameter in the order of Parameter. parameters: five rows
  // where there is an encoder, or none if nobody asks; outputs: none without a decoder. All of as
  // many pixels as there are inputs.
  void run(PixelRows<const float> inputs, PixelRows<float> parameters,
           PixelRows<float> outputs) const;

 private:
  NetworkPipeline(const DenseNetwork* encoder, const DenseNetwork* decoder,
                  const ParameterAxes& axes);

  DenseNetwork encoder_;  // what the kernel's layers point into
  DenseNetwork decoder_;
  std::vector<DenseKernelLayer> encoderLayers_;
  std::vector<DenseKernelLayer> decoderLayers_;
  NetworkPass pass_;
};

}  // namespace cutis
