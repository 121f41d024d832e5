// Layers of a network for vectors of samples, see core/neural/dense/dense_kernel.h. Included once
// per instruction set (Highway).

#if defined(CUTIS_CORE_NEURAL_DENSE_DENSE_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef CUTIS_CORE_NEURAL_DENSE_DENSE_INL_H_
#undef CUTIS_CORE_NEURAL_DENSE_DENSE_INL_H_
#else
#define CUTIS_CORE_NEURAL_DENSE_DENSE_INL_H_
#endif

#include <hwy/highway.h>

#include "core/maths/exp-inl.h"
#include "core/neural/dense/dense_kernel.h"

HWY_BEFORE_NAMESPACE();
namespace cutis {
namespace HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

// The tile of sums that stays in registers: kTileUnits × kTileVectors.
inline constexpr std::size_t kTileUnits = 4;
inline constexpr std::size_t kTileVectors = 3;

template <Activation kActivation, class D, class V = hn::Vec<D>>
HWY_INLINE V Activate(D d, V x) {
  if constexpr (kActivation == Activation::relu) {
    return hn::Max(x, hn::Zero(d));
  } else if constexpr (kActivation == Activation::sigmoid) {
    const V power = ExpOfNegative(d, hn::Neg(hn::Abs(x)));
    const V low = hn::Div(power, hn::Add(power, hn::Set(d, 1.0f)));
    return hn::IfThenElse(hn::Lt(x, hn::Zero(d)), low, hn::Sub(hn::Set(d, 1.0f), low));
  } else if constexpr (kActivation == Activation::squareplus) {
    const V root = hn::Sqrt(hn::MulAdd(x, x, hn::Set(d, 1.0f)));
    return hn::Mul(hn::Set(d, 0.5f), hn::Add(x, root));
  } else {
    return x;
  }
}

// Units row … row + kRows of kTileVectors vectors.
template <std::size_t kRows, Activation kActivation, class D>
HWY_INLINE void Tile(D d, const DenseKernelLayer& layer, std::size_t row,
                     const float* HWY_RESTRICT in, float* HWY_RESTRICT out, std::size_t stride) {
  using V = hn::Vec<D>;
  const std::size_t lanes = hn::Lanes(d);
  V sums[kRows][kTileVectors];
  for (std::size_t r = 0; r < kRows; ++r) {
    for (std::size_t v = 0; v < kTileVectors; ++v) {
      sums[r][v] = hn::Set(d, layer.bias[row + r]);
    }
  }
  const std::size_t inputs = layer.inputs;
  const float* HWY_RESTRICT weights = layer.weights + row * inputs;
  for (std::size_t c = 0; c < inputs; ++c, in += stride) {
    V x[kTileVectors];
    for (std::size_t v = 0; v < kTileVectors; ++v)
      x[v] = hn::LoadU(d, in + v * lanes);
    for (std::size_t r = 0; r < kRows; ++r) {
      const V w = hn::Set(d, weights[r * inputs + c]);
      for (std::size_t v = 0; v < kTileVectors; ++v)
        sums[r][v] = hn::MulAdd(w, x[v], sums[r][v]);
    }
  }
  for (std::size_t r = 0; r < kRows; ++r) {
    for (std::size_t v = 0; v < kTileVectors; ++v) {
      hn::StoreU(Activate<kActivation>(d, sums[r][v]), d, out + (row + r) * stride + v * lanes);
    }
  }
}

template <Activation kActivation>
HWY_NOINLINE void ForwardAs(const DenseKernelLayer& layer, const float* in, float* out,
                            std::size_t stride) {
  const hn::ScalableTag<float> d;
  for (std::size_t i = 0; i < stride; i += kTileVectors * hn::Lanes(d)) {
    std::size_t row = 0;
    for (; row + kTileUnits <= layer.outputs; row += kTileUnits) {
      Tile<kTileUnits, kActivation>(d, layer, row, in + i, out + i, stride);
    }
    for (; row < layer.outputs; ++row) {
      Tile<1, kActivation>(d, layer, row, in + i, out + i, stride);
    }
  }
}

HWY_INLINE void Forward(const DenseKernelLayer& layer, const float* in, float* out,
                        std::size_t stride) {
  switch (layer.activation) {
    case Activation::linear:
      return ForwardAs<Activation::linear>(layer, in, out, stride);
    case Activation::relu:
      return ForwardAs<Activation::relu>(layer, in, out, stride);
    case Activation::sigmoid:
      return ForwardAs<Activation::sigmoid>(layer, in, out, stride);
    case Activation::squareplus:
      return ForwardAs<Activation::squareplus>(layer, in, out, stride);
  }
}

}  // namespace HWY_NAMESPACE
}  // namespace cutis
HWY_AFTER_NAMESPACE();

#endif
