#pragma once  // internal to core/calibrate

// A discrepancy's process, reduced to the few components that maps can hold.

#include "core/calibrate/discrepancy_process.h"
#include "core/skin/model/skin_model.h"
#include "core/skin/profile/discrepancy.h"

namespace cutis {

// The components are those of the greatest variance of reflectance from 380 to 740 nm, of people
// like the process's mean, each with a coefficient of variance 1 over people. What they leave over
// goes to `rest`, as far as eight more spectra tell it. like: as in priorFrom().
Discrepancy reduced(const DiscrepancyProcess& process, const SkinModel& model, int components,
                    const Prior& like);

}  // namespace cutis
