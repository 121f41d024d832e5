#include "src/images/codec/sample_meaning.h"

#include <algorithm>
#include <cstdint>
#include <span>

#include "core/base/parallel.h"

namespace cutis {
namespace {

// Rows of all stored channels in place.
template <typename Sample>
void turnWhite(const ImagePart& part, std::span<Sample> samples, Sample white) {
  const auto channels = static_cast<std::size_t>(part.storedChannels);
  for (std::size_t i = 0; i < samples.size(); ++i) {
    if (static_cast<int>(i % channels) == part.spec.alpha_channel) continue;
    samples[i] = static_cast<Sample>(white - samples[i]);
  }
}

Status convertTile(const StoredColors& colors, const Rect& rect, const std::vector<Plane>& stored,
                   std::vector<Plane>& rgb) {
  const auto channels = static_cast<std::size_t>(colors.channels);
  std::vector<float> plane(rect.pixelCount()), samples(channels * plane.size()),
      light(3 * plane.size());
  for (std::size_t c = 0; c < channels; ++c) {
    CUTIS_CHECK(stored[c].load(rect, plane));
    for (std::size_t p = 0; p < plane.size(); ++p)
      samples[channels * p + c] = plane[p];
  }
  colors.toLinearRec709(samples, light);
  for (std::size_t c = 0; c < 3; ++c) {
    for (std::size_t p = 0; p < plane.size(); ++p)
      plane[p] = light[3 * p + c];
    CUTIS_CHECK(rgb[c].store(rect, plane));
  }
  return {};
}

}  // namespace

bool hasWhiteAtZero(ImageFileKind kind, const OIIO::ImageSpec& spec) {
  return kind == ImageFileKind::tiff && spec.format != OIIO::TypeUInt8 &&
         spec.get_int_attribute("tiff:PhotometricInterpretation", 1) == 0;
}

bool isLogLuv(ImageFileKind kind, const OIIO::ImageSpec& spec) {
  const int photometric = spec.get_int_attribute("tiff:PhotometricInterpretation");
  return kind == ImageFileKind::tiff && (photometric == 32844 || photometric == 32845);
}

bool isWholeLumaChroma(const OIIO::ImageSpec& spec) {
  const auto has = [&](const char* name) {
    return std::find(spec.channelnames.begin(), spec.channelnames.end(), name) !=
           spec.channelnames.end();
  };
  return has("Y") && has("RY") && has("BY") && !has("R");
}

void giveMeaning(const ImagePart& part, std::byte* rows, std::size_t count) {
  if (rowType(part) == OIIO::TypeUInt16) {
    auto* samples = reinterpret_cast<std::uint16_t*>(rows);
    if (part.isWhiteZero) turnWhite<std::uint16_t>(part, {samples, count}, 65535);
  } else if (rowType(part) == OIIO::TypeFloat) {
    auto* samples = reinterpret_cast<float*>(rows);
    if (part.isWhiteZero) turnWhite<float>(part, {samples, count}, 1.0f);
    if (part.factor == 1.0f) return;
    for (std::size_t i = 0; i < count; ++i)
      samples[i] *= part.factor;
  }
}

Result<std::vector<Plane>> convertColors(const StoredColors& colors, std::vector<Plane> stored,
                                         const std::shared_ptr<TileStore>& store,
                                         const JobContext& context) {
  const Plane& size = stored.front();
  std::vector<Plane> planes;
  for (int c = 0; c < 3; ++c)
    planes.emplace_back(size.width(), size.height(), PixelFormat::float32, store);
  CUTIS_CHECK(parallelFor(
      static_cast<std::size_t>(size.tileCount()), {context.stop, {}, {}}, [&](std::size_t i) {
        return convertTile(colors, size.tileRect(static_cast<int>(i)), stored, planes);
      }));
  planes.insert(planes.end(), stored.begin() + colors.channels, stored.end());
  return planes;
}

}  // namespace cutis
