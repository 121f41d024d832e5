#include "src/color/icc_table.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include <Eigen/LU>
#include <Eigen/QR>

#include "src/color/transfer_curve.h"

namespace cutis {
namespace {

// A step of the search, of the numbers of the device; tables have about 33 points.
constexpr float kDifference = 1.0f / 512.0f;
constexpr int kMostSteps = 24;
constexpr double kCloseEnough = 1e-5;  // tables are of 16 bits

cmsUInt32Number formatOf(int channels) {
  if (channels == 1) return TYPE_GRAY_FLT;
  return channels == 4 ? TYPE_CMYK_FLT : TYPE_RGB_FLT;
}

using Triple = std::array<float, 3>;

Triple clamped(const Eigen::Vector3d& value) {
  Triple result = {};
  for (int c = 0; c < 3; ++c)
    result[static_cast<std::size_t>(c)] = static_cast<float>(std::clamp(value[c], 0.0, 1.0));
  return result;
}

Eigen::Vector3d vectorOf(const Triple& value) {
  return {value[0], value[1], value[2]};
}

}  // namespace

IccLibrary::IccLibrary() : context_(cmsCreateContext(nullptr, nullptr)) {}

IccLibrary::~IccLibrary() {
  for (cmsHPROFILE profile : profiles_)
    cmsCloseProfile(profile);
  cmsDeleteContext(context_);
}

cmsHPROFILE IccLibrary::open(std::string_view bytes) {
  cmsHPROFILE profile =
      cmsOpenProfileFromMemTHR(context_, bytes.data(), static_cast<cmsUInt32Number>(bytes.size()));
  if (profile != nullptr) profiles_.push_back(profile);
  return profile;
}

Result<std::shared_ptr<const IccTable>> IccTable::open(std::shared_ptr<IccLibrary> library,
                                                       cmsHPROFILE profile, int channels,
                                                       const Eigen::Matrix3d& rec709FromXyz) {
  std::shared_ptr<IccTable> table(new IccTable);
  table->library_ = std::move(library);
  table->channels_ = channels;
  table->rec709FromXyz_ = rec709FromXyz;
  cmsContext context = table->library_->context();
  cmsHPROFILE xyz = cmsCreateXYZProfileTHR(context);
  constexpr cmsUInt32Number kFlags = cmsFLAGS_NOCACHE | cmsFLAGS_NOOPTIMIZE;
  table->forward_ = cmsCreateTransformTHR(context, profile, formatOf(channels), xyz, TYPE_XYZ_FLT,
                                          INTENT_RELATIVE_COLORIMETRIC, kFlags);
  if (channels == 3 &&
      cmsIsIntentSupported(profile, INTENT_RELATIVE_COLORIMETRIC, LCMS_USED_AS_OUTPUT)) {
    table->backward_ = cmsCreateTransformTHR(context, xyz, TYPE_XYZ_FLT, profile, TYPE_RGB_FLT,
                                             INTENT_RELATIVE_COLORIMETRIC, kFlags);
  }
  cmsCloseProfile(xyz);
  if (table->forward_ == nullptr) {
    return inputError("", "it has no table that can be read");
  }
  return std::shared_ptr<const IccTable>(std::move(table));
}

IccTable::~IccTable() {
  for (cmsHTRANSFORM transform : {forward_, backward_}) {
    if (transform != nullptr) cmsDeleteTransform(transform);
  }
}

void IccTable::toLinear(std::span<const float> device, std::span<float> rgb) const {
  const auto channels = static_cast<std::size_t>(channels_);
  const std::size_t pixels = rgb.size() / 3;
  std::vector<float> numbers(device.begin(), device.end());
  if (channels_ == 4) {
    for (float& ink : numbers)
      ink *= 100.0f;  // LittleCMS counts ink in percent
  }
  std::vector<float> xyz(3 * pixels);
  cmsDoTransform(forward_, numbers.data(), xyz.data(), static_cast<cmsUInt32Number>(pixels));
  for (std::size_t p = 0; p < pixels; ++p) {
    bool sound = true;
    for (std::size_t c = 0; c < channels; ++c)
      sound = sound && std::isfinite(numbers[channels * p + c]);
    const Eigen::Vector3d light =
        rec709FromXyz_ * Eigen::Vector3d(xyz[3 * p], xyz[3 * p + 1], xyz[3 * p + 2]);
    for (std::size_t c = 0; c < 3; ++c) {
      rgb[3 * p + c] = sound ? static_cast<float>(light[static_cast<Eigen::Index>(c)]) : NAN;
    }
  }
}

void IccTable::fromLinear(std::span<float> rgb) const {
  const TransferCurve srgb = TransferCurve::srgb();
  const Eigen::Matrix3d xyzFromRec709 = rec709FromXyz_.inverse();
  for (std::size_t at = 0; at + 2 < rgb.size(); at += 3) {
    const Eigen::Vector3d wanted(rgb[at], rgb[at + 1], rgb[at + 2]);
    if (!wanted.allFinite()) continue;
    Triple device = {};
    if (backward_ != nullptr) {
      const Eigen::Vector3d xyz = xyzFromRec709 * wanted;
      const Triple from = {static_cast<float>(xyz[0]), static_cast<float>(xyz[1]),
                           static_cast<float>(xyz[2])};
      cmsDoTransform(backward_, from.data(), device.data(), 1);
      device = clamped(vectorOf(device));
    } else {
      device = clamped(
          {srgb.fromLight(wanted[0]), srgb.fromLight(wanted[1]), srgb.fromLight(wanted[2])});
    }
    const auto lightOf = [&](const Triple& numbers) {
      Triple light = {};
      toLinear(numbers, light);
      return vectorOf(light);
    };
    Eigen::Vector3d missing = wanted - lightOf(device);
    double share = 1.0;
    for (int step = 0; step < kMostSteps && missing.cwiseAbs().maxCoeff() > kCloseEnough; ++step) {
      Eigen::Matrix3d slope;
      for (int c = 0; c < 3; ++c) {
        Triple moved = device;
        float& number = moved[static_cast<std::size_t>(c)];
        const float difference = number > 0.5f ? -kDifference : kDifference;
        number += difference;
        slope.col(c) = (lightOf(moved) - (wanted - missing)) / double{difference};
      }
      const Eigen::Vector3d change = slope.colPivHouseholderQr().solve(missing);
      if (!change.allFinite()) break;
      const Triple next = clamped(vectorOf(device) + share * change);
      const Eigen::Vector3d left = wanted - lightOf(next);
      if (left.norm() < missing.norm()) {
        device = next;
        missing = left;
        share = 1.0;
      } else if ((share *= 0.5) < 1e-2) {
        break;
      }
    }
    std::copy(device.begin(), device.end(), rgb.begin() + static_cast<std::ptrdiff_t>(at));
  }
}

}  // namespace cutis
