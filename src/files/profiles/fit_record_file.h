#pragma once

// The text of the attribute cutis:fit of maps (core/fit/fit_record.h), JSON on one line.
//
//   {"cutis_fit": 1,
//    "lights": ["white", …],
//    "channels": [{"name": "white.R", "response": [351 numbers, 300 to 1000 nm, sum 1 or all 0]},
//    …], "noise": {"read": x, "proportional": x, "veil": x},   as assumed, standard deviations
//    "prior": {…},                        as in a profile
//    "fixed": {NAME: x, …},               parameters that were held
//    "free": ["oxygenation", …],          constants that were found for each pixel
//    "shading": x,                        standard deviation of the factor on all channels, if any
//    "specular": "included" | "removed",  of which of the profile's discrepancies, if any
//    "discrepancy": true | false}

#include <string>
#include <string_view>

#include "core/base/result.h"
#include "core/fit/fit_record.h"

namespace cutis {

// Responses have eight significant digits, all other numbers read back as they are.
std::string fitRecordText(const FitRecord& record);

// `place` stands in front of errors. Checked with validate() against the profile.
Result<FitRecord> parseFitRecord(std::string_view text, const Profile& profile,
                                 const std::string& place);

}  // namespace cutis
