#include "core/render/color_difference.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>

#include "core/base/parallel.h"
#include "core/render/color_difference_kernel.h"
#include "core/spectra/colorimetry.h"
#include "core/spectra/rgb_primaries.h"

namespace cutis {
namespace {

constexpr std::size_t kPixelsOfPiece = 1 << 15;
constexpr float kNone = std::numeric_limits<float>::quiet_NaN();

// From linear Rec.709 to XYZ of which white is (1, 1, 1).
std::array<std::array<float, 3>, 3> relativeXyz() {
  const Eigen::Vector3d white = kRec709.xyzOfWhite();
  const Eigen::Matrix3d toXyz = white.cwiseInverse().asDiagonal() * xyzFromRec709(white);
  std::array<std::array<float, 3>, 3> rows;
  for (int k = 0; k < 3; ++k) {
    for (int c = 0; c < 3; ++c)
      rows[static_cast<std::size_t>(k)][static_cast<std::size_t>(c)] =
          static_cast<float>(toXyz(k, c));
  }
  return rows;
}

// Where both have an estimate; the channel is empty yet.
PictureBuffer pictureFor(const PictureBuffer& a, const PictureBuffer& b) {
  PictureBuffer difference;
  difference.width = a.width;
  difference.height = a.height;
  difference.present.resize(a.present.size());
  for (std::size_t i = 0; i < a.present.size(); ++i)
    difference.present[i] = a.present[i] && b.present[i];
  difference.channels.emplace_back(a.present.size(), kNone);
  return difference;
}

}  // namespace

Result<PictureBuffer> colorDifference(const PictureBuffer& a, const PictureBuffer& b,
                                      const JobContext& context) {
  PictureBuffer difference = pictureFor(a, b);
  const auto toXyz = relativeXyz();
  const std::size_t count = a.present.size();
  const std::size_t pieces = (count + kPixelsOfPiece - 1) / kPixelsOfPiece;
  CUTIS_CHECK(parallelFor(pieces, context, [&](std::size_t piece) -> Status {
    const std::size_t from = piece * kPixelsOfPiece;
    ColorDifferenceArguments arguments = {{},
                                          {},
                                          toXyz,
                                          difference.channels[0].data() + from,
                                          std::min(kPixelsOfPiece, count - from)};
    for (std::size_t c = 0; c < 3; ++c) {
      arguments.a[c] = a.channels[c].data() + from;
      arguments.b[c] = b.channels[c].data() + from;
    }
    runColorDifferenceKernel(arguments);
    return {};
  }));
  return difference;
}

PictureBuffer absoluteDifference(const PictureBuffer& a, const PictureBuffer& b) {
  PictureBuffer difference = pictureFor(a, b);
  std::transform(a.channels[0].begin(), a.channels[0].end(), b.channels[0].begin(),
                 difference.channels[0].begin(), [](float x, float y) { return std::abs(y - x); });
  return difference;
}

}  // namespace cutis
