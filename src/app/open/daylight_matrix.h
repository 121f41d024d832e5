#pragma once  // internal to src/app/open

#include <Eigen/Core>

#include "core/base/result.h"
#include "core/rig/rig.h"
#include "core/skin/model/skin_model.h"

namespace cutis {

// Channels of the rig's first light to linear Rec.709 of the same skin under D65: least squares
// over skin of the model, with the perfect diffuser kept white. Some milliseconds.
Result<Eigen::Matrix3d> daylightMatrix(const Rig& rig, const SkinModel& model);

}  // namespace cutis
