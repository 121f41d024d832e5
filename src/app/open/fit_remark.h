#pragma once  // internal to src/app/open

// What the user should know of a fit that went well, as facts and in words that hold for window and
// command line alike.

#include <optional>
#include <string>
#include <vector>

#include "core/analyse/constants_summary.h"
#include "core/analyse/exposure.h"
#include "core/fit/fit_options.h"
#include "core/fit/fit_run.h"

namespace cutis {

struct FitRemark {
  enum class Kind {
    exposureChosen,      // another than 1, and how much of the texture is skin at it
    nothingFitted,       // no pixel was there to be solved
    notSettled,          // pixels that met the limit of iterations
    outsideDiffusion,    // pixels whose skin absorbs more than it scatters
    mostlyAssumed,       // a free constant that the channels say little about
    inexact,             // no noise was assumed, and no skin has these channels
    discrepancyOff,      // the profile's discrepancy was left out without being asked to, and could
                         // be asked for
    discrepancyUnknown,  // it was left out, since it does not go with what else was asked
    discrepancyOfSurface,  // not the usual one was estimated
  };
  Kind kind = Kind::nothingFitted;
  // Without a full stop and without options of the command line, to stand behind the source's name.
  std::string sentence;
};

// What becomes of the profile's discrepancy where that does not follow from the options alone, or
// not at first sight. Of simulated skin nothing is left over, and nothing is said. asked: the
// options as they were given, before suitedTo().
std::optional<FitRemark> remarkOnDiscrepancy(const Profile& profile,
                                             const Measurements& measurements,
                                             const FitOptions& asked);

// noise: what was assumed. outsideDiffusion: the share of pixels that the profile's layer optics do
// not hold for, see core/analyse/diffusion_domain.h. exposure: where it was chosen.
std::vector<FitRemark> remarksOn(const FitStatistics& statistics,
                                 const std::vector<ConstantSummary>& constants, FitMethod method,
                                 const NoiseModel& noise,
                                 const std::optional<double>& outsideDiffusion,
                                 const std::optional<ExposureChoice>& exposure);

}  // namespace cutis
