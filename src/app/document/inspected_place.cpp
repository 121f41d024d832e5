#include "src/app/document/inspected_place.h"

#include "core/analyse/doubtful_value.h"
#include "core/fit/discrepancy_choice.h"
#include "core/spectra/colorimetry.h"
#include "src/app/open/photograph_part.h"
#include "src/files/spectral_library.h"

namespace cutis {
namespace {

Result<double> valueAt(const Plane& plane, const Rect& pixel) {
  std::array<float, 1> value;
  CUTIS_CHECK(plane.load(pixel, value));
  return double{value[0]};
}

Status addSource(const Source& source, const Rect& pixel, InspectedPlace& place) {
  const std::vector<Plane>& planes =
      source.image ? source.image->channels : source.measurements.channels;
  for (std::size_t k = 0; k < planes.size(); ++k) {
    CUTIS_TRY(value, valueAt(planes[k], pixel));
    const std::string name = source.image
                                 ? source.image->channelNames[k]
                                 : source.measurements.rig.channelName(static_cast<int>(k));
    place.source.push_back({name, value});
  }
  CUTIS_TRY(part, photographPart(source, pixel, 1));
  place.linear = Eigen::Vector3d(part.channels[0][0], part.channels[1][0], part.channels[2][0]);
  return {};
}

void addDoubts(const Scene& scene, const FitChoice& choice, InspectedPlace& place) {
  const auto& deviation = place.skin->parameterDeviation;
  if (!deviation || scene.source == nullptr) return;
  const Profile& profile = scene.model->profile();
  const Measurements& measurements = scene.source->measurements;
  const auto options = fitOptions(choice, profile);
  if (!options) return;
  const Prior prior =
      assumedPrior(profile, measurements.rig, suitedTo(measurements, options.value()));
  for (const Parameter k : kParameters)
    place.isMostlyPrior[k] =
        isMostlyPrior(place.skin->originalParameters[k], (*deviation)[k], prior, k);
}

Result<SpectrumRows> daylightRows() {
  CUTIS_TRY(light, loadLight({"D65", {}, "D65"}));
  CUTIS_TRY(observer, loadCamera({"cie1931", {}, "cie1931"}));
  return tristimulusRows(light, observer.sensor);
}

void addDifferences(const Scene& scene, const SpectrumRows& rows,
                    const std::optional<PlaceSpectra>& reference, InspectedPlace& place) {
  if (place.linear) {
    const Eigen::Vector3d white = rows.rowwise().sum();
    const Eigen::Vector3d xyz =
        xyzFromRec709(white) * (scene.source->measurements.exposure * *place.linear);
    place.reconstructionDifference =
        deltaE2000(labFromXyz(xyz, white), labOf(place.skin->original, rows));
  }
  if (reference)
    place.referenceDifference =
        deltaE2000(labOf(place.skin->edited, rows), labOf(reference->edited, rows));
}

}  // namespace

Result<InspectedPlace> inspectPlace(const Scene& scene, const FitChoice& choice, const PinSet& pins,
                                    int x, int y) {
  InspectedPlace place;
  place.x = x;
  place.y = y;
  if (scene.source != nullptr) CUTIS_CHECK(addSource(*scene.source, {x, y, x + 1, y + 1}, place));
  const SceneSpectra spectra(scene, choice);
  place.skin = spectra.at(x, y);
  if (!place.skin) return place;
  CUTIS_TRY(rows, daylightRows());
  place.original = skinIndices(place.skin->original, rows);
  place.edited = skinIndices(place.skin->edited, rows);
  addDoubts(scene, choice, place);
  const std::size_t at = pinIndex(pins, pins.reference);
  const bool hasReference = at < pins.pins.size();
  addDifferences(scene, rows,
                 hasReference ? spectra.mean(pins.pins[at].x, pins.pins[at].y, pins.size)
                              : std::optional<PlaceSpectra>(),
                 place);
  return place;
}

}  // namespace cutis
