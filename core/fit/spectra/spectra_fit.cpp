#include "core/fit/spectra/spectra_fit.h"

#include <algorithm>

#include "core/fit/spectra/spectra_misfit.h"
#include "core/fit/spectra/spectra_search.h"
#include "core/skin/profile/parameter_sampling.h"

namespace cutis {
namespace {

constexpr int kSamples = 8192;

}  // namespace

Result<std::vector<SpectrumFit>> fitSpectra(const SkinModel& model,
                                            std::span<const double> wavelengthsNm,
                                            std::span<const double> reflectances,
                                            const JobContext& context,
                                            const MeasurementGeometry& geometry) {
  const SpectraMisfit misfit(model, wavelengthsNm, geometry.edgeLossPerMm);
  std::vector<double> modelled(reflectances.size());
  std::transform(reflectances.begin(), reflectances.end(), modelled.begin(),
                 [&](double measured) { return modelReflectance(geometry, measured); });
  CUTIS_TRY(found,
            searchSpectra(misfit, sampleBox(misfit.axes(), kSamples), {}, modelled, context));
  std::vector<SpectrumFit> fits;
  for (const FoundPoint<kParameterCount>& own : found) {
    fits.push_back({own.point, geometry.enteringShare * own.rmse});
  }
  return fits;
}

}  // namespace cutis
