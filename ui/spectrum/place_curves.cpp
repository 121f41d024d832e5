#include "ui/spectrum/place_curves.h"

#include <QCoreApplication>

#include "ui/widgets/parameter_texts.h"

namespace cutis {
namespace {

QVector<double> toVector(const Spectrum& spectrum) {
  return QVector<double>(spectrum.data(), spectrum.data() + spectrum.size());
}

}  // namespace

PlaceCurves placeCurves(const PlaceSpectra& spectra) {
  const bool isEdited = (spectra.originalParameters != spectra.editedParameters).any();
  return {toVector(spectra.original), isEdited ? toVector(spectra.edited) : QVector<double>(),
          spectra.deviation ? toVector(*spectra.deviation) : QVector<double>()};
}

std::vector<NamedCurve> partCurves(const SkinModel& model, const PlaceSpectra& spectra,
                                   SpectrumQuantity quantity) {
  if (quantity == SpectrumQuantity::reflectance) return {};
  const PlaceParts parts = placeParts(model, spectra);
  if (quantity == SpectrumQuantity::absorption) {
    return {{QCoreApplication::translate("PlaceCurves", "Epidermis"), toVector(parts.epidermis)},
            {QCoreApplication::translate("PlaceCurves", "Dermis"), toVector(parts.dermis)}};
  }
  std::vector<NamedCurve> curves;
  for (const auto& [parameter, contribution] : parts.contributions)
    curves.push_back({parameterTitle(parameter), toVector(contribution)});
  return curves;
}

QVector<MeasuredChannel> measuredChannels(const PlaceSpectra& spectra) {
  QVector<MeasuredChannel> channels;
  for (const ChannelReading& reading : spectra.channels) {
    channels << MeasuredChannel{QString::fromStdString(reading.name),
                                reading.extent.effectiveNm,
                                reading.extent.deviationNm,
                                reading.measured,
                                reading.deviation,
                                reading.modelled};
  }
  return channels;
}

}  // namespace cutis
