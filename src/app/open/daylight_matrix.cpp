#include "src/app/open/daylight_matrix.h"

#include <Eigen/Cholesky>
#include <Eigen/LU>

#include "core/skin/profile/parameter_sampling.h"
#include "core/spectra/colorimetry.h"
#include "src/files/spectral_library.h"

namespace cutis {
namespace {

constexpr int kMatchedSpectra = 2000;
// How much the white of the diffuser counts beside the skin.
constexpr double kWhiteWeight = 200.0;

}  // namespace

Result<Eigen::Matrix3d> daylightMatrix(const Rig& rig, const SkinModel& model) {
  CUTIS_TRY(daylight, loadLight({"D65", {}, {}}));
  CUTIS_TRY(standard, loadCamera({"cie1931", {}, {}}));
  const Eigen::Vector3d white = whitePoint(daylight, standard.sensor);
  const Eigen::Matrix3d fromXyz = xyzFromRec709(white).inverse();
  const SpectrumRows channels = responseRows(rig).topRows(3);
  const SpectrumRows xyz = tristimulusRows(daylight, standard.sensor);

  Eigen::Matrix3d gram = Eigen::Matrix3d::Zero();
  Eigen::Matrix3d cross = Eigen::Matrix3d::Zero();
  const auto match = [&](const Eigen::VectorXd& spectrum, double weight) {
    const Eigen::Vector3d seen = channels.matrix() * spectrum;
    const Eigen::Vector3d wanted = fromXyz * (xyz.matrix() * spectrum);
    gram += weight * seen * seen.transpose();
    cross += weight * seen * wanted.transpose();
  };
  for (const ParameterVector& skin : sampleBox(model.profile().axes, kMatchedSpectra)) {
    match(model.reflectance(skin).matrix(), 1.0);
  }
  match(Eigen::VectorXd::Ones(kSampleCount), kWhiteWeight);
  return Eigen::Matrix3d(gram.ldlt().solve(cross).transpose());
}

}  // namespace cutis
