#pragma once

// profile.json: all constants of the skin model.
//
// The built-in resources/profiles/li2024.json shows every field. Absorption and scattering are in
// mm⁻¹ of wavelengths in nm; "chromophores" names the table of pure absorption (built-in or CSV with
// columns oxyhaemoglobin, deoxyhaemoglobin, water, carotene); parameters.*.spacing is uniform,
// quadratic or cubic.

#include <string>
#include <string_view>
#include <vector>

#include "core/base/result.h"
#include "core/skin/profile.h"
#include "src/files/json_file.h"

namespace cutis {

inline constexpr char kDefaultProfile[] = "li2024";

std::vector<std::string> profileNames();

// A built-in name or a path to a file. Checked with validate(). `place` stands in front of an error
// about the name itself.
Result<Profile> loadProfile(const std::string& nameOrPath, const std::string& place);

// The JSON text a name or path stands for: maps carry it, so that they can be read anywhere.
Result<std::string> profileText(const std::string& nameOrPath, const std::string& place);
Result<Profile> parseProfile(std::string_view text, const std::string& place);

// The "scale", "mean", "sd" object, in a profile or in a file of its own (--prior). Parameters a
// prior file leaves out keep their values from `base`; a prior in a profile must name all
// (base = null).
Result<Prior> parsePrior(const JsonValue& object, const Prior* base);
Result<Prior> readPrior(const std::string& path, const Prior& base);

}  // namespace cutis
