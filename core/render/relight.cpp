#include "core/render/relight.h"

#include <Eigen/LU>

namespace cutis {

SpectrumRows colourRows(const Spectrum& light, const Sensor& observer,
                        ChromaticAdaptation adaptation, const Spectrum& daylight,
                        const Sensor& standardObserver) {
  const Eigen::Vector3d target = whitePoint(daylight, standardObserver);
  const Eigen::Matrix3d toRec709 =
      xyzFromRec709(target).inverse() *
      adaptationMatrix(adaptation, whitePoint(light, observer), target);
  return (toRec709 * tristimulusRows(light, observer).matrix()).array();
}

SpectrumRows cameraRows(const Spectrum& light, const Sensor& camera) {
  SpectrumRows rows(3, kSampleCount);
  for (int c = 0; c < 3; ++c) {
    rows.row(c) = camera.sensitivity.row(c) * light.transpose();
    const double sum = rows.row(c).sum();
    if (sum > 0.0) rows.row(c) /= sum;
  }
  return rows;
}

SpectrumRows bandRow(const Band& band) {
  SpectrumRows row = SpectrumRows::Zero(1, kSampleCount);
  row.row(0).segment(band.first, band.count()) = 1.0 / band.count();
  return row;
}

}  // namespace cutis
