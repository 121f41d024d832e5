#pragma once

// profile.json: all constants of the skin model.
//
// Absorption and scattering are in mm⁻¹, wavelengths in nm; "chromophores" names the table of pure
// absorption (built-in or CSV with columns oxyhaemoglobin, deoxyhaemoglobin, water, carotene);
// parameters.*.spacing is uniform, quadratic or cubic. The built-in li2024 shows the fields every
// profile has. The others, whose absence means the paper's model:
//
//   at_nm of a power law                   coefficient · (λ / at_nm)^exponent; 1
//   absorption.blood_smoothing_nm          standard deviation of a Gaussian over blood; 0
//   absorption.carotene                    "scale", "shift_nm", "smoothing_nm"; 1, 0, 0
//   absorption.fat, dermis.fat_fraction    Gaussian band "peak", "centre_nm", "deviation_nm" of
//   pure
//                                          fat, and how much of it the dermis has
//   epidermis.blood, dermis.blood          "oxygenation" (absorption.oxygenation, which must be
//   left
//                                          out where both layers have their own) and
//                                          "vessel_radius_mm" (0)
//   epidermis.ultraviolet                  "amplitude", "origin_nm", "decay_nm" of a tail on top of
//                                          the epidermis's baseline
//   dermis.baseline_factor                 its baseline over that of the profile; 1
//   dermis.mie_scattering, dermis.rayleigh_scattering
//                                          laws of its own instead of dermis.scattering_ratio
//   sources                                where the values are from: {"epidermis.thickness_mm":
//                                          "a text", …}; a field it names must be there
//   discrepancy                            what the model leaves over of measured skin
//                                          (src/files/profiles/discrepancy_file.h); not known
//
// The prior is that of src/files/profiles/prior_file.h. An unknown field is an error: a misspelt
// option must not pass as absent.

#include <string>
#include <string_view>
#include <vector>

#include "core/base/result.h"
#include "core/skin/profile/profile.h"
#include "src/files/profiles/prior_file.h"

namespace cutis {

// What is used unless a profile is named: the one that describes and predicts measured skin best.
inline constexpr char kDefaultProfile[] = "skin2026b";
// The model of the paper, whose figures benchmarks are compared with.
inline constexpr char kPaperProfile[] = "li2024";

std::vector<std::string> profileNames();

// A built-in name or a path to a file. Checked with validate(). `place` stands in front of an error
// about the name itself.
Result<Profile> loadProfile(const std::string& nameOrPath, const std::string& place);

// The JSON text a name or path stands for: maps carry it, so that they can be read anywhere.
Result<std::string> profileText(const std::string& nameOrPath, const std::string& place);
Result<Profile> parseProfile(std::string_view text, const std::string& place);

}  // namespace cutis
