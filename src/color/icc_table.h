#pragma once  // internal to src/color

// ICC profiles through the transforms of LittleCMS.

#include <lcms2.h>
#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include <Eigen/Core>

#include "core/base/result.h"

namespace cutis {

// A context of LittleCMS of our own, so that it complains nowhere else, and the profiles that were
// opened in it. Opening is for one thread.
class IccLibrary {
 public:
  IccLibrary();
  ~IccLibrary();
  IccLibrary(const IccLibrary&) = delete;
  IccLibrary& operator=(const IccLibrary&) = delete;

  // Null if it is no profile. Lives as long as this.
  cmsHPROFILE open(std::string_view bytes);
  cmsContext context() const { return context_; }

 private:
  cmsContext context_ = nullptr;
  std::vector<cmsHPROFILE> profiles_;
};

// From numbers of a device (1 grey, 3 RGB, 4 CMYK), 0 to 1, to linear Rec.709 and, for RGB, back.
// Any number of threads may use one.
class IccTable {
 public:
  static Result<std::shared_ptr<const IccTable>> open(std::shared_ptr<IccLibrary> library,
                                                      cmsHPROFILE profile, int channels,
                                                      const Eigen::Matrix3d& rec709FromXyz);
  ~IccTable();
  IccTable(const IccTable&) = delete;
  IccTable& operator=(const IccTable&) = delete;

  // `rgb` has three values a pixel; of three channels it may be `device` itself.
  void toLinear(std::span<const float> device, std::span<float> rgb) const;
  // The numbers from 0 to 1 that toLinear() takes to these colours, or to the nearest ones that the
  // search comes to.
  void fromLinear(std::span<float> rgb) const;

 private:
  IccTable() = default;

  std::shared_ptr<IccLibrary> library_;
  int channels_ = 3;
  Eigen::Matrix3d rec709FromXyz_ = Eigen::Matrix3d::Identity();
  cmsHTRANSFORM forward_ = nullptr;
  cmsHTRANSFORM backward_ = nullptr;  // where to begin the search; null: nothing better is known
};

}  // namespace cutis
