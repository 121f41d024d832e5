#pragma once  // internal to src/files/profiles

// calibration.json: how a profile is calibrated on measured spectra.
//
//   cutis_calibration   1
//   name, description   of the profile that comes out; figures are added to the description
//   start               the profile to begin from, a built-in name or a file beside the recipe: it
//                       says everything that is not calibrated
//   step_nm             distance of the wavelengths compared, a multiple of the grid's
//   pull                weight of what is known of the constants (core/calibrate/calibration.h)
//   spectra             one object per file of spectra, in the order they are given:
//                         name
//                         specular             "included", "excluded" or "crossed"
//                         specular_share       as it begins
//                         aperture_radius_mm   left out where no light is lost sideways
//                         aims                 [{"from_nm", "to_nm", "rms"}…]; errors that would do
//   prior               {"spectra": NAME, "noise": x}: whom the prior is found from, and the
//   standard
//                       deviation of what is measured from what is modelled
//   constants           [{"field", "low", "high", "expected", "sd", "scale", "note", "spectra"}…]:
//                         field    of the profile ("epidermis.thickness_mm"), or specular_share of
//                                  the "spectra" named
//                         scale    of sd: "linear" or "log"; linear
//                         note     why, for the profile's sources; may be left out
//
//   discrepancy         {"components": n}: learned of the spectra, of which there is one file
//                       (core/calibrate/discrepancy_study.h). Then all constants and the prior are
//                       those of the start: step_nm, pull, prior, constants and aims are left out
//
// An unknown field is an error.

#include <optional>
#include <string>
#include <vector>

#include "core/base/result.h"
#include "core/calibrate/calibration.h"
#include "core/skin/model/measurement_geometry.h"

namespace cutis {

struct CalibrationSpectra {
  std::string name;
  SpecularPart specular = SpecularPart::excluded;
  double specularShare = 0.0;
  double edgeLossPerMm = 0.0;
  std::vector<SpectralAim> aims;
};

struct CalibrationConstant {
  CalibratedConstant constant;         // its name: the field
  std::optional<std::size_t> spectra;  // whose specular share it is; none: the profile's
  std::string note;
};

struct CalibrationRecipe {
  std::string name;
  std::string description;
  std::string start;      // as the recipe names it
  std::string startText;  // of that profile, valid
  int stepNm = 10;
  double pull = 0.0;
  std::vector<CalibrationSpectra> spectra;
  std::vector<CalibrationConstant> constants;
  std::size_t priorSpectra = 0;
  double priorNoise = 0.0;
  // How many a discrepancy has; then there are no constants. 0: none is learned.
  int components = 0;

  bool learnsDiscrepancy() const { return components > 0; }
};

// A built-in name or a path. `place` stands in front of an error about the name itself.
Result<CalibrationRecipe> loadCalibrationRecipe(const std::string& nameOrPath,
                                                const std::string& place);

}  // namespace cutis
