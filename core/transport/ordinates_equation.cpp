#include "core/transport/ordinates_equation.h"

#include <cmath>

#include <Eigen/Cholesky>

namespace cutis {
namespace {

// Cₑ and Cₒ. Isotropic: Cₑ = a √w √wᵀ, Cₒ = 0.
template <int N>
struct Redistribution {
  StreamMatrix<N> even, odd;
};

template <int N>
Redistribution<N> redistribution(const Streams<N>& streams, double albedo, double anisotropy,
                                 double peak) {
  const StreamVector<N> root = streams.weight.cwiseSqrt();
  Redistribution<N> c = {StreamMatrix<N>::Zero(), StreamMatrix<N>::Zero()};
  StreamVector<N> before = StreamVector<N>::Zero();
  StreamVector<N> polynomial = StreamVector<N>::Ones();
  double power = 1.0;
  for (int l = 0; l < N; ++l) {
    const double moment = (power - peak) / (1.0 - peak);
    const StreamVector<N> weighted = root.cwiseProduct(polynomial);
    StreamMatrix<N>& sum = l % 2 == 0 ? c.even : c.odd;
    sum += (albedo * (2 * l + 1) * moment * weighted) * weighted.transpose();
    const StreamVector<N> next =
        ((2 * l + 1) * streams.cosine.cwiseProduct(polynomial) - static_cast<double>(l) * before) /
        (l + 1);
    before = polynomial;
    polynomial = next;
    power *= anisotropy;
  }
  // Cₑ √w = a √w, for a share of the albedo that a sum over few directions leaves out or adds.
  const StreamVector<N> missing = albedo - (c.even * root).cwiseQuotient(root).array();
  c.even.diagonal() += missing;
  c.odd.diagonal() += missing;
  return c;
}

template <int N>
LayerEquation<N> isotropicEquation(const Streams<N>& streams, double albedo) {
  const StreamVector<N> inverse = streams.cosine.cwiseInverse();
  const StreamVector<N> source = inverse.cwiseProduct(streams.weight.cwiseSqrt());
  LayerEquation<N> equation;
  equation.rates = (-albedo * source) * source.transpose();
  equation.rates.diagonal() += inverse.cwiseAbs2();
  equation.root = inverse.cwiseSqrt().asDiagonal();
  return equation;
}

}  // namespace

template <int N>
LayerEquation<N> layerEquation(const Streams<N>& streams, const Scatterer& scatterer) {
  const double g = scatterer.anisotropy;
  if (g == 0.0) return isotropicEquation(streams, scatterer.albedo);
  const double peak = std::pow(g, N);
  const double depthScale = 1.0 - scatterer.albedo * peak;
  const double albedo = scatterer.albedo * (1.0 - peak) / depthScale;
  const Redistribution<N> c = redistribution(streams, albedo, g, peak);
  const auto inverseRoot = streams.cosine.cwiseInverse().cwiseSqrt().asDiagonal();
  const StreamMatrix<N> one = StreamMatrix<N>::Identity();
  const StreamMatrix<N> a = inverseRoot * (one - c.even) * inverseRoot;
  const StreamMatrix<N> b = inverseRoot * (one - c.odd) * inverseRoot;
  LayerEquation<N> equation;
  equation.root = b.llt().matrixL();
  equation.rates = equation.root.transpose() * a * equation.root;
  equation.depthScale = depthScale;
  return equation;
}

template LayerEquation<16> layerEquation(const Streams<16>&, const Scatterer&);
template LayerEquation<32> layerEquation(const Streams<32>&, const Scatterer&);

}  // namespace cutis
