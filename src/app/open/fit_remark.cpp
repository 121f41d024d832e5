#include "src/app/open/fit_remark.h"

#include "core/analyse/diffusion_domain.h"
#include "core/base/number_text.h"
#include "core/fit/assumed_noise.h"
#include "core/fit/discrepancy_choice.h"

namespace cutis {
namespace {

// The exact setting bends the parameters to whatever is in the channels.
constexpr double kExactResidual = 2e-4;
// A share of all pixels.
constexpr double kMostNotSettled = 0.01;

FitRemark leftOut(FitRemark::Kind kind, const std::string& reason) {
  return {kind, "what the model leaves over of measured skin is not estimated, since " + reason};
}

}  // namespace

std::optional<FitRemark> remarkOnDiscrepancy(const Profile& profile,
                                             const Measurements& measurements,
                                             const FitOptions& asked) {
  using enum FitRemark::Kind;
  if (asked.method != FitMethod::refined || profile.discrepancies.empty()) return {};
  if (measurements.isSimulated) return {};
  const bool removed = asked.surface == SurfaceLight::removed;
  if (chosenDiscrepancy(profile, measurements.rig, asked) != nullptr) {
    if (!removed) return {};
    return FitRemark{discrepancyOfSurface,
                     "what the model leaves over is taken from people whose surface reflection was "
                     "removed, as it is here"};
  }
  if (asked.discrepancy) return {};
  if (asked.free.count() > 0)
    return leftOut(discrepancyUnknown, "the constants found for each pixel explain it");
  if (asksForExact(measurements.rig, asked))
    return leftOut(discrepancyOff, "photographs without noise count as the model's own skin");
  return leftOut(discrepancyUnknown,
                 "the profile does not know it where the surface's reflection "
                 "is " +
                     surfaceLightName(asked.surface));
}

std::vector<FitRemark> remarksOn(const FitStatistics& statistics,
                                 const std::vector<ConstantSummary>& constants, FitMethod method,
                                 const NoiseModel& noise, const std::optional<double>& shareOutside,
                                 const std::optional<ExposureChoice>& exposure) {
  using enum FitRemark::Kind;
  std::vector<FitRemark> remarks;
  if (exposure && exposure->exposure != 1.0) {
    remarks.push_back(
        {exposureChosen, "exposure " + formatNumber(exposure->exposure, 4) + " brings " +
                             percentText(exposure->inside, 3) +
                             " of the pixels into the profile's range of skin colours"});
  }
  const FitStatistics::Pixels& pixels = statistics.pixels;
  const double share =
      static_cast<double>(pixels.noConvergence) / static_cast<double>(pixels.total);
  if (pixels.solved + pixels.duplicate == 0) {
    remarks.push_back(
        {nothingFitted, "no pixel could be fitted; all are masked, black or saturated"});
  } else if (share > kMostNotSettled) {
    remarks.push_back({notSettled, percentText(share, 2) +
                                       " of the pixels did not settle; their values are rough"});
  }
  if (shareOutside.value_or(0.0) > kNoticeableOutside) {
    remarks.push_back({FitRemark::Kind::outsideDiffusion,
                       "in " + percentText(*shareOutside, 2) +
                           " of the pixels the skin absorbs more visible light than it scatters, "
                           "where diffusion, "
                           "the layer optics of this profile, no longer holds; choose a profile by "
                           "adding–doubling"});
  }
  for (const ConstantSummary& summary : constants) {
    if (summary.openShare <= kMostlyAssumed) continue;
    remarks.push_back({mostlyAssumed, std::string(constantName(summary.constant)) +
                                          " is mostly what was assumed: these channels leave " +
                                          percentText(summary.openShare, 2) +
                                          " of its uncertainty; photograph under more lights"});
  }
  if (method == FitMethod::refined && noise.isExact() && statistics.meanResidual > kExactResidual) {
    remarks.push_back({inexact, "no skin meets these channels exactly (residual " +
                                    formatNumber(statistics.meanResidual, 2) +
                                    " on average), and without noise all of that goes into the "
                                    "maps; give the noise model"});
  }
  return remarks;
}

}  // namespace cutis
