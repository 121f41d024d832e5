#pragma once  // internal to src/cli/commands/validate

#include <string>
#include <vector>

#include "core/calibrate/capture_study.h"
#include "src/cli/commands/validate/capture_table.h"
#include "src/report/drawing.h"

namespace cutis {

// The median error of every estimator by wavelength: a panel for each set and for what was learned,
// all to one scale. photographs: how they were taken, in words.
Drawing capturePlot(const std::vector<CaptureResult>& results,
                    const std::vector<MeasuredSpectra>& sets, const CaptureNames& names,
                    const std::string& photographs);

}  // namespace cutis
