#pragma once

// Spectra of several people as rows of comma-separated text, written while they are computed.

#include <functional>
#include <string_view>
#include <vector>

#include "core/base/job_context.h"
#include "core/base/result.h"
#include "core/skin/model/instrument_model.h"

namespace cutis {

// The header row 300,302,…,1000 and a row of reflectances per set, with nine significant digits, in
// parts and in order. Errors: those of `write`. Cancelled if asked to stop.
Status writeSpectra(const InstrumentModel& model, const std::vector<ParameterVector>& sets,
                    const std::function<Status(std::string_view text)>& write,
                    const JobContext& context);

}  // namespace cutis
