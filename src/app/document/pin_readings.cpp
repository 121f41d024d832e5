#include "src/app/document/pin_readings.h"

#include "core/spectra/colorimetry.h"
#include "src/files/spectral_library.h"

namespace cutis {
namespace {

// Of D65 and the observer that the indices are defined for.
Result<SpectrumRows> indexRows() {
  CUTIS_TRY(light, loadLight({"D65", {}, "D65"}));
  CUTIS_TRY(observer, loadCamera({"cie1931", {}, "cie1931"}));
  return tristimulusRows(light, observer.sensor);
}

}  // namespace

Result<std::vector<PinReading>> pinReadings(const SceneSpectra& spectra, const PinSet& set,
                                            const JobContext& context) {
  CUTIS_TRY(rows, indexRows());
  std::vector<PinReading> readings;
  for (const Pin& pin : set.pins) {
    if (context.stopRequested()) return Cancelled();
    PinReading reading;
    reading.pin = pin;
    reading.place = spectra.mean(pin.x, pin.y, set.size);
    if (reading.place) {
      reading.original = skinIndices(reading.place->original, rows);
      reading.edited = skinIndices(reading.place->edited, rows);
    }
    readings.push_back(std::move(reading));
  }
  const std::size_t reference = pinIndex(set, set.reference);
  if (reference == readings.size() || !readings[reference].place) return readings;
  const Eigen::Vector3d color = labOf(readings[reference].place->edited, rows);
  for (PinReading& reading : readings) {
    if (reading.place) reading.difference = deltaE2000(labOf(reading.place->edited, rows), color);
  }
  return readings;
}

}  // namespace cutis
