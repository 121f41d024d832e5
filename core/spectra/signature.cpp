#include "core/spectra/signature.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <limits>

#include "core/base/random.h"
#include "core/spectra/grid.h"

namespace cutis {
namespace {

// Evenly spread over [0, 1]; made of whole numbers, the same everywhere.
const SpectrumRows& probes() {
  static const SpectrumRows rows = [] {
    SpectrumRows drawn(kSignatureProbes, kSampleCount);
    for (Eigen::Index probe = 0; probe < drawn.rows(); ++probe) {
      Random random(350, static_cast<std::uint64_t>(probe));
      for (double& weight : drawn.row(probe))
        weight = random.uniform();
    }
    return drawn;
  }();
  return rows;
}

}  // namespace

bool alike(const Signature& a, const Signature& b) {
  return std::equal(a.begin(), a.end(), b.begin(), b.end(), [](float x, float y) {
    return std::abs(x - y) <= kSignatureTolerance * std::max(std::abs(x), std::abs(y));
  });
}

SignatureBuilder& SignatureBuilder::add(double value) {
  constexpr double kMost = std::numeric_limits<float>::max();
  signature_.push_back(static_cast<float>(std::clamp(value, -kMost, kMost)));
  return *this;
}

// A text counts as one whole number below 2²⁰, which a float holds.
SignatureBuilder& SignatureBuilder::add(std::string_view text) {
  std::uint64_t bits = text.size();
  for (const char c : text)
    bits = mixBits(bits ^ static_cast<unsigned char>(c));
  return add(static_cast<double>(bits >> 44));
}

SignatureBuilder& SignatureBuilder::add(std::span<const double> spectrum) {
  assert(spectrum.size() == std::size_t{kSampleCount});
  const Eigen::Map<const Eigen::VectorXd> samples(spectrum.data(), kSampleCount);
  for (const double sum : probes().matrix() * samples)
    add(sum);
  return *this;
}

}  // namespace cutis
