#include "core/transport/doubling.h"

#include <cmath>

#include <Eigen/Cholesky>

namespace cutis {
namespace {

constexpr double kThinnest = 0.5;  // √E h where doubling starts
// Thicker layers cannot be told from this one: e^(−2 k h) is gone for the slowest decay k ≈ 1e-6 of
// an albedo of 1 − 1e-12.
constexpr double kThickest = 3e7;
constexpr double kSettled = 1e-14;

// tanh x / x ≈ n / m with n = 945 + 105 x² + x⁴ and m = 945 + 420 x² + 15 x⁴.
template <int N>
LayerAdmittance<N> thinLayer(const LayerEquation<N>& equation, double halfDepth) {
  const StreamMatrix<N> x2 = equation.rates * (halfDepth * halfDepth);
  const StreamMatrix<N> x4 = x2 * x2;
  const StreamMatrix<N> one = StreamMatrix<N>::Identity();
  const StreamMatrix<N> n = 945.0 * one + 105.0 * x2 + x4;
  const StreamMatrix<N> m = 945.0 * one + 420.0 * x2 + 15.0 * x4;
  const StreamMatrix<N> y = x2 * Eigen::LLT<StreamMatrix<N>>(m).solve(n) / halfDepth;
  const StreamMatrix<N> w = Eigen::LLT<StreamMatrix<N>>(n).solve(m) / halfDepth;
  // Back to the coordinates s, d.
  const StreamMatrix<N> inverse = equation.root.template triangularView<Eigen::Lower>().solve(one);
  const StreamMatrix<N> even = inverse.transpose() * y * inverse;
  const StreamMatrix<N> odd = inverse.transpose() * w * inverse;
  return {0.5 * (even + even.transpose()), 0.5 * (odd + odd.transpose())};
}

// One doubling; returns how far Y moved.
template <int N>
double doubleOnce(LayerAdmittance<N>& layer) {
  const StreamMatrix<N> sum = layer.odd + layer.even;
  const Eigen::LLT<StreamMatrix<N>> decomposed(sum);
  const StreamMatrix<N> half = decomposed.matrixL().solve(layer.even);
  StreamMatrix<N> even = 2.0 * layer.even;
  even.noalias() -= 2.0 * half.transpose() * half;
  const double moved = (even - layer.even).cwiseAbs().maxCoeff();
  layer.even = even;
  layer.odd = 0.5 * sum;
  return moved;
}

template <int N>
LayerAdmittance<N> doubledLayer(const LayerEquation<N>& equation, double halfDepth) {
  // The largest row sum bounds the largest eigenvalue.
  const double fastest = std::sqrt(equation.rates.cwiseAbs().rowwise().sum().maxCoeff());
  const double ratio = halfDepth * fastest / kThinnest;
  const int steps = ratio > 1.0 ? static_cast<int>(std::ceil(std::log2(ratio))) : 0;
  LayerAdmittance<N> layer = thinLayer(equation, std::ldexp(halfDepth, -steps));
  for (int i = 0; i < steps; ++i) {
    if (doubleOnce(layer) < kSettled) break;
  }
  return layer;
}

}  // namespace

template <int N>
LayerAdmittance<N> layerAdmittance(const LayerEquation<N>& equation, double opticalDepth) {
  return doubledLayer(equation, std::fmin(0.5 * opticalDepth * equation.depthScale, kThickest));
}

template <int N>
StreamMatrix<N> halfSpaceAdmittance(const LayerEquation<N>& equation) {
  return doubledLayer(equation, kThickest).even;
}

template LayerAdmittance<8> layerAdmittance(const LayerEquation<8>&, double);
template LayerAdmittance<16> layerAdmittance(const LayerEquation<16>&, double);
template LayerAdmittance<32> layerAdmittance(const LayerEquation<32>&, double);
template StreamMatrix<8> halfSpaceAdmittance(const LayerEquation<8>&);
template StreamMatrix<16> halfSpaceAdmittance(const LayerEquation<16>&);
template StreamMatrix<32> halfSpaceAdmittance(const LayerEquation<32>&);

}  // namespace cutis
