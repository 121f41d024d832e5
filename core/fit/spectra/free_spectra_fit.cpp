#include "core/fit/spectra/free_spectra_fit.h"

#include "core/fit/spectra/free_misfit.h"
#include "core/fit/spectra/spectra_search.h"

namespace cutis {
namespace {

// Shares of the progress: the fit with the profile's own constants, and the tables of the layers.
constexpr double kOwnShare = 0.1, kTablesShare = 0.2;

// From what was found with the profile's own constants.
template <int N>
Result<std::vector<FreeSpectrumFit>> fitFrom(const std::vector<SpectrumFit>& own,
                                             const SkinModel& model,
                                             std::span<const double> wavelengthsNm,
                                             std::span<const double> reflectances,
                                             const FreeConstants& free, const JobContext& context,
                                             const MeasurementGeometry& geometry) {
  CUTIS_TRY(misfit, FreeMisfit<N>::make(model, wavelengthsNm, free, geometry.edgeLossPerMm,
                                        context.child(kOwnShare, kTablesShare)));
  std::vector<SearchPoint<N>> known;
  for (const SpectrumFit& fit : own)
    known.push_back(misfit.setAt(fit.parameters, constantsOf(model.profile())));
  CUTIS_TRY(found, searchSpectra<N>(misfit, searchSamples<N>(misfit.axes()), known,
                                    modelReflectances(geometry, reflectances),
                                    context.child(kTablesShare, 1.0)));
  std::vector<FreeSpectrumFit> fits;
  for (const FoundPoint<N>& one : found) {
    fits.push_back(
        {{one.point.template head<kParameterCount>(), geometry.enteringShare * one.rmse, {}},
         misfit.constantsAt(one.point)});
  }
  return fits;
}

}  // namespace

std::size_t fewestWavelengths(const FreeConstants& free) {
  return kFewestWavelengths + static_cast<std::size_t>(free.count());
}

Result<std::vector<FreeSpectrumFit>> fitSpectraFreely(const SkinModel& model,
                                                      std::span<const double> wavelengthsNm,
                                                      std::span<const double> reflectances,
                                                      const FreeConstants& free,
                                                      const JobContext& context,
                                                      const MeasurementGeometry& geometry) {
  const double ownEnd = free.count() > 0 ? kOwnShare : 1.0;
  CUTIS_TRY(own,
            fitSpectra(model, wavelengthsNm, reflectances, context.child(0.0, ownEnd), geometry));
  if (free.count() == 1) {
    return fitFrom<kParameterCount + 1>(own, model, wavelengthsNm, reflectances, free, context,
                                        geometry);
  }
  if (free.count() == 2) {
    return fitFrom<kParameterCount + 2>(own, model, wavelengthsNm, reflectances, free, context,
                                        geometry);
  }
  std::vector<FreeSpectrumFit> fits;
  for (const SpectrumFit& fit : own)
    fits.push_back({fit, constantsOf(model.profile())});
  return fits;
}

}  // namespace cutis
