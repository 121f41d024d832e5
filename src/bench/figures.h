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

#include "core/evaluate/error_bound.h"
#include "core/evaluate/error_metrics.h"
#include "src/bench/method.h"

namespace cutis {

inline constexpr std::array<double, 5> kBenchNoises = {0.0, 0.001, 0.002, 0.005, 0.01};
// Where a single noise must do: the built-in rigs' own.
inline constexpr double kUsualNoise = 0.005;

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

// The refined fit of people with what the profile's model leaves over, and the bound that includes
// it.
struct DiscrepancyFigures {
  double noise = 0.0;
  ErrorBound errors;  // reached, mean squared errors
  ErrorBound bound;
  double overBound = 0.0;  // visible
};

struct CoverageFigures {
  std::string prior;  // "wide", "population"
  double noise = 0.0;
  Coverage coverage;
};

// All parameters together.
Coverage::Count pooled(const std::array<Coverage::Count, kParameterCount>& counts);

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
  double noise = 0.0;
  int threads = 0;
  double seconds = 0.0;
  bool scaled = false;  // from nanoseconds a pixel, not run
  // Figures of pictures that were run.
  std::size_t solved = 0;
  std::size_t duplicate = 0;
  double meanIterations = 0.0;
  // Most that the fit held besides what was there before, which is mostly the photographs; none
  // where the system does not say.
  std::optional<std::size_t> memoryBytes;
};

// Mean squared errors of reflectance, by band.
struct BandErrors {
  double visible = 0.0;       // 400–700 nm
  double ultraviolet = 0.0;   // 300–400 nm
  double nearInfrared = 0.0;  // 700–1000 nm
};

// The refined fit with the profile's own prior, from one kind of start.
struct StartFigures {
  std::string start;
  double visibleMse = 0.0;
  double nanosecondsPerPixel = 0.0;  // what finds the start included
  double meanIterations = 0.0;
};

// Networks, of all lights or of some.
struct NetworkFigures {
  struct AtNoise {
    double noise = 0.0;
    double encodedMse = 0.0;  // visible; channels → ChromNN → skin model
    double bothMse = 0.0;     // visible; channels → ChromNN → SpectraNN
  };

  int lights = 0;
  int channels = 0;
  std::size_t weights = 0;       // of both
  std::size_t workPerPixel = 0;  // multiply-adds, from channels to the rig's channels
  BandErrors decoded;            // SpectraNN alone, of true parameters
  std::vector<AtNoise> errors;
  int size = 0;                // pixels a side of the picture that was timed
  double encodeSeconds = 0.0;  // channels → parameters
  double bothSeconds = 0.0;    // channels → parameters → the rig's channels
};

// The coarse maps that are shown before a fit is complete.
struct FirstPictureFigures {
  int size = 0;  // pixels a side
  double seconds = 0.0;
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
  std::vector<NetworkFigures> networks;
  std::vector<StartFigures> starts;
  std::optional<double> trainingSeconds;        // of networks for the rig, if any were trained
  std::vector<DiscrepancyFigures> discrepancy;  // none for a profile without one
  std::vector<CoverageFigures> coverage;
  std::vector<VariantFigures> lights;
  std::vector<VariantFigures> parameters;
  std::vector<VariantFigures> encodings;
  std::vector<PictureFigures> sizes;
  std::vector<PictureFigures> scaling;  // by threads
  std::optional<FirstPictureFigures> firstPicture;
  std::optional<double> speedRatio;  // exhaustive three-stage search over refined
};

// Whether a method is judged at a noise: the exact setting believes every digit and is for pixels
// without noise alone.
inline bool isJudgedAt(BenchMethod method, double noise) {
  return method != BenchMethod::refinedExact || noise == 0.0;
}

// The figures of a method at a noise; none if it was not run.
const MethodFigures* figuresOf(const std::vector<MethodFigures>& all, BenchMethod method,
                               double noise);

// Pixels a side of the pictures that the paper and our own goals speak of.
inline constexpr int kUsualSize = 2048;

// The picture of uncorrelated pixels that a method's speed is quoted for: the largest up to
// kUsualSize that was run, else one that was scaled; none if there is none.
const PictureFigures* largestPicture(const BenchFigures& figures, BenchMethod method);
// How many times as many pixels kUsualSize has.
double usualScaling(int size);
// Seconds for a picture of kUsualSize, scaled where a smaller one was run.
std::optional<double> usualSeconds(const BenchFigures& figures, BenchMethod method);

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
