#include "core/analyse/skin_locus.h"

#include <array>

namespace cutis {
namespace {

// Shares of a range.
constexpr std::array kLines = {0.02, 0.05, 0.1, 0.2, 0.4, 1.0};
constexpr std::array kAlong = {0.0, 0.02, 0.035, 0.05, 0.1, 0.15, 0.2, 0.3, 0.4, 0.6, 0.8, 1.0};

LocusLine lineOf(const SkinModel& model, const ParameterVector& others,
                 const SpectrumRows& tristimulus, Parameter fixed, Parameter growing,
                 double share) {
  const ParameterAxes& axes = model.profile().axes;
  LocusLine line = {fixed, share * axes[fixed].maximum, {}};
  ParameterVector parameters = others;
  parameters[fixed] = line.amount;
  for (const double along : kAlong) {
    parameters[growing] = along * axes[growing].maximum;
    const Eigen::ArrayXd reflectance = model.reflectance(parameters);
    line.points.push_back(chromaticityOf(tristimulus.matrix() * reflectance.matrix()));
  }
  return line;
}

}  // namespace

Eigen::Vector2d chromaticityOf(const Eigen::Vector3d& xyz) {
  return Eigen::Vector2d(4.0 * xyz[0], 9.0 * xyz[1]) / (xyz[0] + 15.0 * xyz[1] + 3.0 * xyz[2]);
}

std::vector<LocusLine> skinLocus(const SkinModel& model, const ParameterVector& others,
                                 const SpectrumRows& tristimulus) {
  std::vector<LocusLine> lines;
  for (const double share : kLines)
    lines.push_back(lineOf(model, others, tristimulus, kMelanin, kHaemoglobinDermal, share));
  for (const double share : kLines)
    lines.push_back(lineOf(model, others, tristimulus, kHaemoglobinDermal, kMelanin, share));
  return lines;
}

}  // namespace cutis
