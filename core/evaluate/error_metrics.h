#pragma once

// How far estimated skin is from the true one: spectra first, then colours, then parameters (error
// protocol, resources/manual/accuracy.md). Errors of reflectance are absolute, perfect diffuser =
// 1; NaN in an estimate makes that pixel's errors NaN. Thread-safe: const after construction.

#include <array>
#include <cstddef>
#include <span>
#include <vector>

#include "core/base/job_context.h"
#include "core/base/result.h"
#include "core/evaluate/error_protocol.h"
#include "core/skin/model/skin_model.h"
#include "core/skin/profile/prior.h"
#include "core/spectra/colorimetry.h"

namespace cutis {

struct PixelError {
  // Mean squared error of reflectance over the band, both ends included.
  double visible = 0.0;       // 400–700 nm: the paper's figure
  double ultraviolet = 0.0;   // 300–400 nm
  double nearInfrared = 0.0;  // 700–1000 nm
  double deltaE_D65 = 0.0;    // CIEDE2000
  double deltaE_A = 0.0;
  double typologyAngle = 0.0;                            // of the true colour under D65, degrees
  ParameterVector parameters = ParameterVector::Zero();  // estimated minus true
};

// The errors of a number of pixels together.
struct ErrorSummary {
  std::size_t pixels = 0;
  double visibleMse = 0.0;
  double ultravioletMse = 0.0;
  double nearInfraredMse = 0.0;
  double medianDeltaE_D65 = 0.0;
  double deltaE95_D65 = 0.0;  // 95 of 100 pixels are below
  double medianDeltaE_A = 0.0;
  double deltaE95_A = 0.0;
  ParameterVector parameterRmse = ParameterVector::Zero();
};
// All zero for no pixels.
ErrorSummary summarise(std::span<const PixelError> errors);

// Four groups of skin by the individual typology angle, after the six classes of Chardon et al.
// 1991: light (over 41°, with very light), medium (over 10°: intermediate and tan), brown (over
// −30°), dark.
inline constexpr int kToneCount = 4;
int toneOf(double typologyAngle);
const char* toneName(int tone);

class ErrorMeter {
 public:
  ErrorMeter(const SkinModel& model, const Spectrum& d65, const Spectrum& a,
             const Sensor& observer);

  // estimates: [parameter][pixel], in the parameters' units. About 12 µs a pixel and core.
  // Cancelled if asked to stop.
  Result<std::vector<PixelError>> measure(std::span<const ParameterVector> people,
                                          std::span<const float> estimates,
                                          const JobContext& context) const;

 private:
  struct Colours {
    Eigen::Matrix<double, 3, Eigen::Dynamic, Eigen::RowMajor> rows;
    Eigen::Vector3d white;
  };

  FullSpectra spectra_;
  Colours daylight_;
  Colours incandescent_;
};

// How often a parameter lies within two posterior deviations of its estimate; 95.4 % would be right
// for a normal posterior. Apart: where the measurement at least halved the prior's deviation, and
// where it is mostly the prior that speaks. In the prior's scale: logarithms where it has them.
struct Coverage {
  struct Count {
    std::size_t pixels = 0;
    std::size_t inside = 0;
    double share() const;  // NaN for no pixels
  };
  std::array<Count, kParameterCount> measured;
  std::array<Count, kParameterCount> assumed;
};
// estimates, deviations: [parameter][pixel].
Coverage coverageOf(std::span<const ParameterVector> people, std::span<const float> estimates,
                    std::span<const float> deviations, const Prior& prior);

}  // namespace cutis
