#include "src/app/views/picture_bands.h"

#include <utility>
#include <vector>

#include "core/base/parallel.h"

namespace cutis {
namespace {

void append(const PictureBuffer& band, std::size_t roomFor, PictureBuffer& picture) {
  picture.width = band.width;
  picture.height += band.height;
  picture.channels.resize(band.channels.size());
  for (std::size_t c = 0; c < band.channels.size(); ++c) {
    std::vector<float>& channel = picture.channels[c];
    channel.reserve(roomFor);
    channel.insert(channel.end(), band.channels[c].begin(), band.channels[c].end());
  }
  picture.present.reserve(roomFor);
  picture.present.insert(picture.present.end(), band.present.begin(), band.present.end());
}

}  // namespace

Result<PictureBuffer> joinedBands(std::size_t count, const JobContext& context,
                                  const std::function<Result<PictureBuffer>(std::size_t i)>& band) {
  std::vector<PictureBuffer> bands(count);
  CUTIS_CHECK(parallelFor(count, context, [&](std::size_t i) -> Status {
    CUTIS_TRY(pixels, band(i));
    bands[i] = std::move(pixels);
    return {};
  }));
  std::size_t pixels = 0;
  for (const PictureBuffer& each : bands)
    pixels += each.present.size();
  PictureBuffer picture;
  for (const PictureBuffer& each : bands)
    append(each, pixels, picture);
  return picture;
}

}  // namespace cutis
