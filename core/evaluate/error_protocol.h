#pragma once

// Pixels of the error protocol of resources/manual/accuracy.md (the paper's Table 1, made
// reproducible): people drawn at random, their exact spectra, their channels through a rig, and
// noise.
//
// Everything is deterministic by its seed, for any number of threads. Thread-safe.

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "core/base/job_context.h"
#include "core/base/result.h"
#include "core/fit/population.h"
#include "core/rig/rig.h"
#include "core/skin/model/compiled_model.h"
#include "core/skin/model/skin_model.h"
#include "core/skin/profile/prior.h"

namespace cutis {

// Mean and deviation of a uniform population, linear: what a fit can know of it beforehand.
Prior priorOf(const ParameterBox& box);

// Reflectance of several people at all samples of the grid, in double precision: out[sample][i].
// Within 1e-12 of SkinModel. About 5 µs a person and core.
class FullSpectra {
 public:
  explicit FullSpectra(const SkinModel& model);
  void evaluate(std::span<const ParameterVector> people, std::vector<double>& out) const;

 private:
  CompiledModel nodes_;
};

// How a photograph stores its channels: as they are, or in steps. Values beyond 0…1 are clipped in
// the integer kinds.
enum class SampleEncoding {
  float32,
  half,
  linear16,  // 16-bit integers, proportional to light
  srgb8,     // 8-bit integers through the sRGB curve
};

// Channels of one rig: multiplicative noise, each independent of all others.
class ProtocolPixels {
 public:
  // Sums the exact 351-sample spectra. Cancelled if asked to stop.
  static Result<ProtocolPixels> create(const SkinModel& model, const Rig& rig,
                                       std::vector<ParameterVector> people,
                                       const JobContext& context);

  std::size_t count() const { return people_.size(); }
  std::size_t channelCount() const { return channelCount_; }
  const std::vector<ParameterVector>& people() const { return people_; }

  // [channel][pixel]: exact · (1 + noise · n), n normal, never negative. Different noises of one
  // seed are the same draws, scaled.
  std::vector<float> photograph(double noise, std::uint64_t seed,
                                SampleEncoding encoding = SampleEncoding::float32) const;

 private:
  std::vector<ParameterVector> people_;
  std::size_t channelCount_ = 0;
  std::vector<double> exact_;  // [channel][pixel]
};

}  // namespace cutis
