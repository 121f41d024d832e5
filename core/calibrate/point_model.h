#pragma once  // internal to core/calibrate

// The model of one choice of constants, at the wavelengths of a calibration alone: the inner part
// of core/calibrate/calibration.cpp.

#include <memory>
#include <span>
#include <vector>

#include "core/base/job_context.h"
#include "core/base/result.h"
#include "core/calibrate/calibration.h"
#include "core/skin/layers/table.h"
#include "core/skin/model/instrument_model.h"
#include "core/skin/model/skin_model.h"

namespace cutis {

// Thread-safe: const after construction.
class PointModel {
 public:
  // samples: where it will be evaluated. Where `like` has the same layers but for what absorbs, its
  // table serves here, too. Errors: those of LayerTable::make.
  static Result<PointModel> make(const CalibrationPoint& point, std::span<const int> samples,
                                 const PointModel* like, const JobContext& context);

  const SkinModel& skin() const { return *skin_; }
  const InstrumentModel& asSeenBy(std::size_t set) const { return measured_[set]; }

 private:
  PointModel() = default;

  std::shared_ptr<const LayerTable> table_;  // null: diffusion
  std::shared_ptr<const SkinModel> skin_;
  std::vector<InstrumentModel> measured_;
};

}  // namespace cutis
