#pragma once

// Parameters of several people as rows of comma-separated text.

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/result.h"
#include "core/skin/profile/parameter_axis.h"

namespace cutis {

// One set, "0.02,0.5,0.02,0.01,0.001", in the order of Parameter. `place` names it in errors.
Result<ParameterVector> parseParameters(std::span<const std::string_view> fields,
                                        const ParameterAxes& axes, const std::string& place,
                                        ErrorKind kind);

// A file with the header melanin,melanin_blend,haemoglobin_dermal,haemoglobin_epidermal,carotene,
// in any order; each row is checked against the profile's ranges. Errors name the line.
Result<std::vector<ParameterVector>> readParameterSets(const std::string& path,
                                                       const ParameterAxes& axes);

}  // namespace cutis
