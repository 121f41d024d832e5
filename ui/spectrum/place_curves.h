#pragma once  // internal to ui/spectrum

// What a document knows of a place as the plot takes it.

#include "src/app/document/place_parts.h"
#include "ui/plot/spectrum_figure.h"

namespace cutis {

// Without an edited curve where nothing is edited.
PlaceCurves placeCurves(const PlaceSpectra& spectra);
QVector<MeasuredChannel> measuredChannels(const PlaceSpectra& spectra);
// None of reflectance.
std::vector<NamedCurve> partCurves(const SkinModel& model, const PlaceSpectra& spectra,
                                   SpectrumQuantity quantity);

}  // namespace cutis
