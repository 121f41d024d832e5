#pragma once

// Parameter sets as rows of a CSV file, and their spectra as rows of another.

#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/job_context.h"
#include "core/base/result.h"
#include "core/skin/model/instrument_model.h"
#include "core/skin/profile/parameter_axis.h"

namespace cutis {

// One set, "0.02,0.5,0.02,0.01,0.001", in the order of Parameter. `place` names it in errors.
Result<ParameterVector> parseParameters(const std::vector<std::string_view>& fields,
                                        const ParameterAxes& axes, const std::string& place,
                                        ErrorKind kind);

// A file with the header melanin,melanin_blend,haemoglobin_dermal,haemoglobin_epidermal,carotene,
// in any order; each row is checked against the profile's ranges. Errors name the line.
Result<std::vector<ParameterVector>> readParameterSets(const std::string& path,
                                                       const ParameterAxes& axes);

// The header row 300,302,…,1000 and a row of reflectances per set, with nine significant digits, in
// parts and in order.
Status writeSpectra(const InstrumentModel& model, const std::vector<ParameterVector>& sets,
                    const std::function<Status(std::string_view text)>& write,
                    const JobContext& context);

}  // namespace cutis
