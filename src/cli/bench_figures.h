#pragma once

// What a run of the benchmark found out: plain numbers, for the table, the report and the plot.
//
// Errors are absolute errors of reflectance squared, perfect diffuser = 1; noise is the
// proportional standard deviation of a channel; times are wall clock with all threads that were
// allowed.

#include <array>
#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "core/simulate/error_bound.h"
#include "core/simulate/error_metrics.h"
#include "src/cli/bench_methods.h"

namespace cutis {

// One method at one noise.
struct MethodFigures {
  BenchMethod method = BenchMethod::refinedWide;
  double noise = 0.0;
  ErrorSummary errors;
  std::array<ErrorSummary, kToneCount> tones;
  double nanosecondsPerPixel = 0.0;
  double meanIterations = 0.0;
  double unconvergedShare = 0.0;
  std::optional<double> overBound;  // visible MSE over the bound; not without noise
};

// The bound at one noise.
struct BoundFigures {
  double noise = 0.0;
  ErrorBound bound;
  std::optional<double> printed;  // the design's figure for the visible band, for this rig
};

struct CoverageFigures {
  std::string prior;  // "wide", "population"
  double noise = 0.0;
  Coverage coverage;
};

// One of a handful of things compared with all else equal.
struct VariantFigures {
  std::string variant;
  double noise = 0.0;
  ErrorSummary errors;
  std::optional<ErrorBound> bound;
};

// A whole picture.
struct PictureFigures {
  std::string content;  // "uncorrelated", "sample"
  BenchMethod method = BenchMethod::refinedWide;
  int size = 0;  // pixels a side
  int threads = 0;
  double seconds = 0.0;
  bool scaled = false;  // from nanoseconds a pixel, not run
  // Of pictures that were run.
  std::size_t solved = 0;
  std::size_t duplicate = 0;
  double meanIterations = 0.0;
  std::size_t peakMemoryBytes = 0;  // of the process so far, the simulated photographs included
};

struct BenchFigures {
  std::string version;
  std::string processor;
  std::string instructionSet;
  int threads = 0;
  std::string profile;
  std::string rig;
  std::size_t pixels = 0;
  std::size_t subsample = 0;  // pixels of the exhaustive searches
  bool quick = false;

  std::vector<BoundFigures> bounds;
  std::vector<MethodFigures> methods;
  std::vector<MethodFigures> sample;  // pixels of the sample instead of the population
  std::vector<CoverageFigures> coverage;
  std::vector<VariantFigures> lights;
  std::vector<VariantFigures> parameters;
  std::vector<VariantFigures> encodings;
  std::vector<PictureFigures> sizes;
  std::vector<PictureFigures> scaling;  // by threads
  std::optional<double> speedRatio;     // exhaustive three-stage search over refined
};

// The figures of a method at a noise; none if it was not run.
const MethodFigures* figuresOf(const std::vector<MethodFigures>& all, BenchMethod method,
                               double noise);

// What the paper published (§7.1, Table 1 and text), of pictures of 2048² pixels on a Titan X. No
// noise. Errors: mean over its four groups of people.
struct PublishedFigures {
  const char* method;
  double secondsFor2048;
  double visibleMse;
};
inline constexpr std::array<PublishedFigures, 3> kPublished = {{
    {"full search", 2.88 * 3600.0, 2.087e-4},
    {"three stages", 13.91 * 60.0, 2.151e-4},
    {"network", 2.27, 3.355e-8},
}};

}  // namespace cutis
