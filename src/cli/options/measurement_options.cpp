#include "src/cli/options/measurement_options.h"

#include "src/cli/options/option_values.h"
#include "src/files/io/csv.h"

namespace cutis {
namespace {

constexpr double kMostShare = 0.5;
constexpr double kLeastRadiusMm = 0.1, kMostRadiusMm = 1000.0;

Result<SpecularPart> specularPart(const std::string& word) {
  if (word.empty() || word == "excluded") return SpecularPart::excluded;
  if (word == "included") return SpecularPart::included;
  if (word == "cross-polarised") return SpecularPart::crossPolarised;
  return usageError("--specular",
                    "'" + word + "' is unknown; choose included, excluded or cross-polarised");
}

}  // namespace

void addSpecularOptions(CLI::App& command, const std::string& what,
                        MeasurementArguments& arguments) {
  command
      .add_option("--specular", arguments.specular,
                  "Whether the " + what +
                      " contain the surface reflection: included, excluded or cross-polarised, "
                      "which keeps it out (default: excluded)")
      ->type_name("WORD");
  command
      .add_option("--specular-share", arguments.share,
                  "With --specular included: the surface reflection, as far as it is measured "
                  "(default: 0.04)")
      ->type_name("S");
}

void addMeasurementOptions(CLI::App& command, MeasurementArguments& arguments) {
  addSpecularOptions(command, "spectra", arguments);
  command
      .add_option("--aperture-radius", arguments.apertureRadius,
                  "Radius in mm of the spot that is lit and seen, where it is so small that light "
                  "is lost sideways (default: none is lost)")
      ->type_name("MM");
}

Result<MeasurementSetting> parseMeasurement(const MeasurementArguments& arguments) {
  MeasurementSetting setting;
  CUTIS_TRY(specular, specularPart(arguments.specular));
  setting.specular = specular;
  if (!arguments.share.empty()) {
    if (specular != SpecularPart::included) {
      return usageError("--specular-share", "this goes with --specular included");
    }
    CUTIS_TRY(share, realNumber("--specular-share", arguments.share, 0.0, kMostShare));
    setting.share = share;
  }
  if (!arguments.apertureRadius.empty()) {
    CUTIS_TRY(radius, realNumber("--aperture-radius", arguments.apertureRadius, kLeastRadiusMm,
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
