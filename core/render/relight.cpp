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

SpectrumRows bandRow(const Band& band) {
  SpectrumRows row = SpectrumRows::Zero(1, kSampleCount);
  row.row(0).segment(band.first, band.count()) = 1.0 / band.count();
  return row;
}

}  // namespace cutis
