#include "core/neural/network_kernel.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "core/neural/network_kernel.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include <hwy/contrib/math/math-inl.h>

#include "core/neural/dense/dense-inl.h"

HWY_BEFORE_NAMESPACE();
namespace cutis {
namespace HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

// One block of kSampleStep pixels on its way.
struct Block {
  float* values;  // [unit][kSampleStep]
  float* next;
  float* poison;  // [kSampleStep]: 0, or NaN where an input is not finite
  std::size_t first;
  std::size_t live;

  void swap() {
    float* other = values;
    values = next;
    next = other;
  }
};

HWY_INLINE void Load(const NetworkPass& pass, const PixelRows<const float>& inputs,
                     const Block& block) {
  const hn::ScalableTag<float> d;
  for (std::size_t k = 0; k < pass.inputCount; ++k) {
    float* row = block.values + k * kSampleStep;
    const float* from = inputs.data + k * inputs.stride + block.first;
    for (std::size_t i = 0; i < block.live; ++i)
      row[i] = from[i];
    for (std::size_t i = block.live; i < kSampleStep; ++i)
      row[i] = 0.0f;
  }
  for (std::size_t i = 0; i < kSampleStep; i += hn::Lanes(d)) {
    auto poison = hn::Zero(d);
    for (std::size_t k = 0; k < pass.inputCount; ++k) {
      const auto value = hn::LoadU(d, block.values + k * kSampleStep + i);
      poison = hn::Add(poison, hn::Mul(value, hn::Zero(d)));
    }
    hn::StoreU(poison, d, block.poison + i);
  }
}

HWY_INLINE void Logarithms(const NetworkPass& pass, const Block& block) {
  const hn::ScalableTag<float> d;
  const auto least = hn::Set(d, pass.smallestChannel);
  for (std::size_t i = 0; i < pass.inputCount * kSampleStep; i += hn::Lanes(d)) {
    const auto value = hn::Max(hn::LoadU(d, block.values + i), least);
    hn::StoreU(hn::Log(d, value), d, block.values + i);
  }
}

// (C / C_max)^(1/exponent)
template <class D, class V = hn::Vec<D>>
HWY_INLINE V CoordinateOf(D d, const KernelAxis& axis, V value) {
  const V share = hn::Min(hn::Max(hn::Mul(value, hn::Set(d, axis.inverseMaximum)), hn::Zero(d)),
                          hn::Set(d, 1.0f));
  if (axis.exponent == 1) return share;
  if (axis.exponent == 2) return hn::Sqrt(share);
  const V log = hn::Log(d, hn::Max(share, hn::Set(d, 1e-30f)));
  return ExpOfNegative(d, hn::Mul(log, hn::Set(d, 1.0f / 3.0f)));
}

HWY_INLINE void Coordinates(const NetworkPass& pass, const Block& block) {
  const hn::ScalableTag<float> d;
  for (int k = 0; k < kParameterCount; ++k) {
    float* row = block.values + static_cast<std::size_t>(k) * kSampleStep;
    for (std::size_t i = 0; i < kSampleStep; i += hn::Lanes(d)) {
      hn::StoreU(CoordinateOf(d, pass.axes[k], hn::LoadU(d, row + i)), d, row + i);
    }
  }
}

HWY_INLINE void Run(const DenseKernelLayer* layers, std::size_t count, Block& block) {
  for (std::size_t i = 0; i < count; ++i) {
    Forward(layers[i], block.values, block.next, kSampleStep);
    block.swap();
  }
}

// Adds the poison on the way out.
HWY_INLINE void StoreRow(const float* row, const Block& block, float* to) {
  for (std::size_t i = 0; i < block.live; ++i)
    to[block.first + i] = row[i] + block.poison[i];
}

HWY_INLINE void StoreParameters(const NetworkPass& pass, const Block& block,
                                const PixelRows<float>& to) {
  const hn::ScalableTag<float> d;
  float* row = block.next;
  for (int k = 0; k < kParameterCount; ++k) {
    const float* from = block.values + static_cast<std::size_t>(k) * kSampleStep;
    const KernelAxis& axis = pass.axes[k];
    for (std::size_t i = 0; i < kSampleStep; i += hn::Lanes(d)) {
      const auto coordinate = hn::LoadU(d, from + i);
      auto value = hn::Mul(coordinate, hn::Set(d, axis.maximum));
      for (int e = 1; e < axis.exponent; ++e)
        value = hn::Mul(value, coordinate);
      hn::StoreU(value, d, row + i);
    }
    StoreRow(row, block, to.data + static_cast<std::size_t>(k) * to.stride);
  }
}

void Pass(const NetworkPass& pass, const PixelRows<const float>& inputs,
          const PixelRows<float>& parameters, const PixelRows<float>& outputs, float* scratch) {
  for (std::size_t first = 0; first < inputs.count; first += kSampleStep) {
    const std::size_t left = inputs.count - first;
    Block block = {scratch, scratch + pass.widest * kSampleStep,
                   scratch + 2 * pass.widest * kSampleStep, first,
                   left < kSampleStep ? left : kSampleStep};
    Load(pass, inputs, block);
    if (pass.encoderLayers > 0) {
      Logarithms(pass, block);
      Run(pass.encoder, pass.encoderLayers, block);
      if (parameters.data != nullptr) StoreParameters(pass, block, parameters);
    } else {
      Coordinates(pass, block);
    }
    if (pass.decoderLayers == 0) continue;
    Run(pass.decoder, pass.decoderLayers, block);
    for (std::size_t k = 0; k < pass.outputCount; ++k) {
      StoreRow(block.values + k * kSampleStep, block, outputs.data + k * outputs.stride);
    }
  }
}

}  // namespace HWY_NAMESPACE
}  // namespace cutis
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace cutis {

HWY_EXPORT(Pass);

std::size_t networkScratchSize(const NetworkPass& pass) {
  return (2 * pass.widest + 1) * kSampleStep;
}

void runNetworkKernel(const NetworkPass& pass, PixelRows<const float> inputs,
                      PixelRows<float> parameters, PixelRows<float> outputs, float* scratch) {
  HWY_DYNAMIC_DISPATCH(Pass)(pass, inputs, parameters, outputs, scratch);
}

}  // namespace cutis
#endif  // HWY_ONCE
