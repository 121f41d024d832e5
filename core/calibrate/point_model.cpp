#include "core/calibrate/point_model.h"

#include <utility>

#include "core/skin/profile/absorption.h"

namespace cutis {
namespace {

bool scatterAlike(const Profile& a, const Profile& b) {
  return a.epidermalThicknessMm == b.epidermalThicknessMm &&
         a.refractiveIndex == b.refractiveIndex &&
         (epidermalScattering(a) == epidermalScattering(b)).all() &&
         (dermalScattering(a) == dermalScattering(b)).all();
}

}  // namespace

Result<PointModel> PointModel::make(const CalibrationPoint& point, std::span<const int> samples,
                                    const PointModel* like, const JobContext& context) {
  PointModel model;
  if (point.profile.layerOptics == LayerOpticsKind::diffusion) {
    model.skin_ = std::make_shared<const SkinModel>(point.profile);
  } else {
    if (like && like->table_ && scatterAlike(like->skin_->profile(), point.profile)) {
      model.table_ = like->table_;
    } else {
      CUTIS_TRY(table, LayerTable::make(point.profile, samples, {}, context));
      model.table_ = std::make_shared<const LayerTable>(std::move(table));
    }
    model.skin_ = std::make_shared<const SkinModel>(point.profile, model.table_);
  }
  for (const MeasurementGeometry& geometry : point.geometries) {
    model.measured_.emplace_back(*model.skin_, geometry);
  }
  return model;
}

}  // namespace cutis
