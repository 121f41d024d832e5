#include "src/cli/options/measurement_options.h"

#include "core/base/echoed_text.h"
#include "core/base/number_text.h"
#include "src/cli/options/add_option.h"
#include "src/cli/options/option_values.h"

namespace cutis {
namespace {

constexpr double kMostShare = 0.5;
constexpr double kLeastRadiusMm = 0.1, kMostRadiusMm = 1000.0;

Result<SpecularPart> specularPart(const std::string& word) {
  if (word.empty() || word == "excluded") return SpecularPart::excluded;
  if (word == "included") return SpecularPart::included;
  if (word == "cross-polarised") return SpecularPart::crossPolarised;
  return usageError("--specular",
                    inQuotes(word) + " is unknown; choose included, excluded or cross-polarised");
}

}  // namespace

void addSpecularOptions(CLI::App& command, const std::string& what, MeasurementOptions& options) {
  addOption(command, "--specular", options.specular, "WORD",
            "Whether the " + what +
                " contain the surface reflection: included, excluded or cross-polarised, "
                "which keeps it out (default: excluded)");
  addOption(command, "--specular-share", options.share, "S",
            "With --specular included: the surface reflection, as far as it is measured "
            "(default: 0.04)");
}

void addMeasurementOptions(CLI::App& command, MeasurementOptions& options) {
  addSpecularOptions(command, "spectra", options);
  addOption(command, "--aperture-radius", options.apertureRadius, "MM",
            "Radius in mm of the spot that is lit and seen, where it is so small that light "
            "is lost sideways (default: none is lost)");
}

Result<MeasurementSetting> parseMeasurement(const MeasurementOptions& options) {
  MeasurementSetting setting;
  CUTIS_TRY(specular, specularPart(options.specular));
  setting.specular = specular;
  if (!options.share.empty()) {
    if (specular != SpecularPart::included) {
      return usageError("--specular-share", "this goes with --specular included");
    }
    CUTIS_TRY(share, realNumber("--specular-share", options.share, 0.0, kMostShare));
    setting.share = share;
  }
  if (!options.apertureRadius.empty()) {
    CUTIS_TRY(radius, realNumber("--aperture-radius", options.apertureRadius, kLeastRadiusMm,
                                 kMostRadiusMm));
    setting.edgeLossPerMm = edgeLossOfAperture(radius);
  }
  return setting;
}

MeasurementGeometry geometryOf(const MeasurementSetting& setting, const Profile& profile) {
  MeasurementGeometry geometry;
  if (setting.specular == SpecularPart::included) {
    geometry = measurementGeometry(setting.specular, profile.refractiveIndex, setting.share);
  }
  geometry.edgeLossPerMm = setting.edgeLossPerMm;
  return geometry;
}

std::string described(const MeasurementSetting& setting) {
  std::string text = "surface reflection excluded";
  if (setting.specular == SpecularPart::included) {
    text = "surface reflection included (" + formatNumber(setting.share, 4) + ")";
  }
  if (setting.edgeLossPerMm > 0.0) {
    text += ", edge loss " + formatNumber(setting.edgeLossPerMm, 3) + " per mm";
  }
  return text;
}

}  // namespace cutis
