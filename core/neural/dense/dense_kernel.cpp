#include "core/neural/dense/dense_kernel.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "core/neural/dense/dense_kernel.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include "core/neural/dense/dense-inl.h"

HWY_BEFORE_NAMESPACE();
namespace cutis {
namespace HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

void ForwardLayer(const DenseKernelLayer& layer, const float* in, float* out, std::size_t stride) {
  Forward(layer, in, out, stride);
}

// The slope of the activation, from its output y.
template <Activation kActivation, class D, class V = hn::Vec<D>>
HWY_INLINE V Slope(D d, V y) {
  const V one = hn::Set(d, 1.0f);
  if constexpr (kActivation == Activation::relu) {
    return hn::IfThenElseZero(hn::Gt(y, hn::Zero(d)), one);
  } else if constexpr (kActivation == Activation::sigmoid) {
    return hn::NegMulAdd(y, y, y);
  } else {
    // y (y − x) = 1/4, so x follows from y.
    const V square = hn::Mul(y, y);
    return hn::Div(square, hn::Add(square, hn::Set(d, 0.25f)));
  }
}

template <Activation kActivation>
HWY_INLINE void Through(const float* out, float* gradient, std::size_t count) {
  const hn::ScalableTag<float> d;
  for (std::size_t i = 0; i < count; i += hn::Lanes(d)) {
    const auto slope = Slope<kActivation>(d, hn::LoadU(d, out + i));
    hn::StoreU(hn::Mul(hn::LoadU(d, gradient + i), slope), d, gradient + i);
  }
}

void ThroughActivation(Activation activation, const float* out, float* gradient,
                       std::size_t count) {
  switch (activation) {
    case Activation::linear:
      return;
    case Activation::relu:
      return Through<Activation::relu>(out, gradient, count);
    case Activation::sigmoid:
      return Through<Activation::sigmoid>(out, gradient, count);
    case Activation::squareplus:
      return Through<Activation::squareplus>(out, gradient, count);
  }
}

// A tile of kRows × kColumns sums over all samples.
template <std::size_t kRows, std::size_t kColumns>
HWY_INLINE void Outer(const float* HWY_RESTRICT gradient, const float* HWY_RESTRICT in,
                      std::size_t inputs, std::size_t stride, float* HWY_RESTRICT sum) {
  const hn::ScalableTag<float> d;
  using V = hn::Vec<decltype(d)>;
  V sums[kRows][kColumns];
  for (auto& row : sums) {
    for (V& v : row)
      v = hn::Zero(d);
  }
  for (std::size_t i = 0; i < stride; i += hn::Lanes(d)) {
    V x[kColumns];
    for (std::size_t c = 0; c < kColumns; ++c)
      x[c] = hn::LoadU(d, in + c * stride + i);
    for (std::size_t r = 0; r < kRows; ++r) {
      const V g = hn::LoadU(d, gradient + r * stride + i);
      for (std::size_t c = 0; c < kColumns; ++c)
        sums[r][c] = hn::MulAdd(g, x[c], sums[r][c]);
    }
  }
  for (std::size_t r = 0; r < kRows; ++r) {
    for (std::size_t c = 0; c < kColumns; ++c) {
      sum[r * inputs + c] += hn::GetLane(hn::SumOfLanes(d, sums[r][c]));
    }
  }
}

template <std::size_t kRows>
HWY_INLINE void OuterRows(const float* gradient, const float* in, std::size_t inputs,
                          std::size_t stride, float* sum) {
  std::size_t c = 0;
  for (; c + kTileVectors <= inputs; c += kTileVectors) {
    Outer<kRows, kTileVectors>(gradient, in + c * stride, inputs, stride, sum + c);
  }
  for (; c < inputs; ++c)
    Outer<kRows, 1>(gradient, in + c * stride, inputs, stride, sum + c);
}

void AddWeightGradient(const float* gradient, std::size_t outputs, const float* in,
                       std::size_t inputs, std::size_t stride, float* weightGradient,
                       float* biasGradient) {
  std::size_t row = 0;
  for (; row + kTileUnits <= outputs; row += kTileUnits) {
    OuterRows<kTileUnits>(gradient + row * stride, in, inputs, stride,
                          weightGradient + row * inputs);
  }
  for (; row < outputs; ++row) {
    OuterRows<1>(gradient + row * stride, in, inputs, stride, weightGradient + row * inputs);
  }
  const hn::ScalableTag<float> d;
  for (row = 0; row < outputs; ++row) {
    auto sum = hn::Zero(d);
    for (std::size_t i = 0; i < stride; i += hn::Lanes(d)) {
      sum = hn::Add(sum, hn::LoadU(d, gradient + row * stride + i));
    }
    biasGradient[row] += hn::GetLane(hn::SumOfLanes(d, sum));
  }
}

}  // namespace HWY_NAMESPACE
}  // namespace cutis
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace cutis {

HWY_EXPORT(ForwardLayer);
HWY_EXPORT(ThroughActivation);
HWY_EXPORT(AddWeightGradient);

void forwardLayer(const DenseKernelLayer& layer, const float* in, float* out, std::size_t stride) {
  HWY_DYNAMIC_DISPATCH(ForwardLayer)(layer, in, out, stride);
}

void throughActivation(Activation activation, const float* out, float* gradient,
                       std::size_t count) {
  HWY_DYNAMIC_DISPATCH(ThroughActivation)(activation, out, gradient, count);
}

void addWeightGradient(const float* gradient, std::size_t outputs, const float* in,
                       std::size_t inputs, std::size_t stride, float* weightGradient,
                       float* biasGradient) {
  HWY_DYNAMIC_DISPATCH(AddWeightGradient)
  (gradient, outputs, in, inputs, stride, weightGradient, biasGradient);
}

}  // namespace cutis
#endif  // HWY_ONCE
