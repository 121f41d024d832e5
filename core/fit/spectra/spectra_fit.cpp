#include "core/fit/spectra/spectra_fit.h"

#include "core/fit/spectra/spectra_equations.h"
#include "core/fit/spectra/spectra_search.h"

namespace cutis {
namespace {

// N: the number of the profile's parameters.
template <int N>
Result<std::vector<SpectrumFit>> fitAll(const SkinModel& model,
                                        std::span<const double> wavelengthsNm,
                                        std::span<const double> reflectances,
                                        const JobContext& context,
                                        const MeasurementGeometry& geometry) {
  const SpectralMisfit<N> misfit(model, wavelengthsNm, geometry.edgeLossPerMm);
  CUTIS_TRY(found, searchSpectra<N>(misfit, searchSamples<N>(misfit.axes()), {},
                                    modelReflectances(geometry, reflectances), context));
  std::vector<SpectrumFit> fits;
  for (const FoundPoint<N>& own : found) {
    const auto parameters = misfit.parametersAt(own.point);
    fits.push_back({own.point.template head<kParameterCount>(),
                    geometry.enteringShare * own.rmse,
                    {parameters.begin() + kParameterCount, parameters.end()}});
  }
  return fits;
}

}  // namespace

Result<std::vector<SpectrumFit>> fitSpectra(const SkinModel& model,
                                            std::span<const double> wavelengthsNm,
                                            std::span<const double> reflectances,
                                            const JobContext& context,
                                            const MeasurementGeometry& geometry) {
  static_assert(kMostFurther == 2, "one case for each number of further chromophores");
  switch (model.profile().further.size()) {
    case 0:
      return fitAll<kParameterCount>(model, wavelengthsNm, reflectances, context, geometry);
    case 1:
      return fitAll<kParameterCount + 1>(model, wavelengthsNm, reflectances, context, geometry);
    case 2:
      return fitAll<kParameterCount + 2>(model, wavelengthsNm, reflectances, context, geometry);
    default:
      return inputError(model.profile().name,
                        "spectra are fitted with at most two chromophores beside the five "
                        "parameters, and this profile has more; leave some out");
  }
}

}  // namespace cutis
