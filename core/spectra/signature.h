#pragma once

// What something is, in a few numbers that are compared with a tolerance: a hash with the patience
// for processors that round differently. Spectra go in as their sums against fixed random weights,
// so that a change anywhere shows.
//
// Thread-safe: pure functions and values. Numbers are finite; beyond what a float holds they count
// as the largest float.

#include <span>
#include <string_view>
#include <vector>

namespace cutis {

using Signature = std::vector<float>;

// The share of a number, or of a spectrum's sum, below which two signatures are of one thing: ten
// times what a float rounds away, and a thousandth of what a photograph can distinguish.
inline constexpr float kSignatureTolerance = 1e-6f;

// Numbers by which a spectrum is recognised.
inline constexpr int kSignatureProbes = 8;

// Whether they have as many numbers, each pair within the tolerance, relative to the larger. NaN is
// like nothing.
bool alike(const Signature& a, const Signature& b);

// Takes what ContentHash takes (core/base/content_hash.h), in the same way.
class SignatureBuilder {
 public:
  SignatureBuilder& add(double value);
  SignatureBuilder& add(std::string_view text);
  // kSampleCount values of the wavelength grid.
  SignatureBuilder& add(std::span<const double> spectrum);

  const Signature& signature() const { return signature_; }

 private:
  Signature signature_;
};

}  // namespace cutis
