#include "src/images/preview/smaller_version.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace cutis {
namespace {

constexpr int kMostPages = 16;
constexpr int kReducedPage = 1;  // TIFF 6.0, §8, NewSubfileType

// By how much a side was reduced, if it was by a whole number; 0: it was not.
int reductionOfSides(const Rect& whole, const OIIO::ImageSpec& small) {
  const int reduction =
      static_cast<int>(std::lround(static_cast<double>(whole.width()) / std::max(1, small.width)));
  const auto fits = [&](int side, int smallSide) {
    return reduction >= 2 && smallSide >= side / reduction &&
           smallSide <= (side + reduction - 1) / reduction;
  };
  if (!fits(whole.width(), small.width) || !fits(whole.height(), small.height)) return 0;
  return reduction;
}

ImagePart madeSmaller(const ImagePart& part, const OIIO::ImageSpec& spec) {
  ImagePart small = part;
  small.spec = spec;
  small.stored = {spec.x, spec.y, spec.x + spec.width, spec.y + spec.height};
  small.window = small.stored;
  return small;
}

// What has the channels and samples of the picture, and is large enough.
std::optional<SmallerVersion> versionOf(const ImagePart& part, const OIIO::ImageSpec& spec,
                                        int leastSide) {
  const int reduction = reductionOfSides(part.stored, spec);
  if (reduction == 0 || std::max(spec.width, spec.height) < leastSide ||
      spec.channelnames != part.spec.channelnames || spec.format != part.spec.format ||
      spec.channelformats != part.spec.channelformats) {
    return std::nullopt;
  }
  return SmallerVersion{madeSmaller(part, spec), reduction};
}

std::optional<SmallerVersion> smallerLevel(ImageReader& reader, const ImagePart& part,
                                           int leastSide) {
  std::optional<SmallerVersion> smallest;
  for (int level = 1; level < reader.levelCount(part.index); ++level) {
    auto version = versionOf(part, reader.levelSpec(part.index, level), leastSide);
    if (!version) continue;
    version->part.level = level;
    smallest = std::move(version);
  }
  return smallest;
}

std::optional<SmallerVersion> smallerPage(ImageReader& reader, const ImagePart& part,
                                          int leastSide) {
  std::optional<SmallerVersion> smallest;
  for (int page = 1; page <= kMostPages; ++page) {
    const OIIO::ImageSpec spec = reader.levelSpec(page, 0);
    if (spec.format == OIIO::TypeUnknown) break;
    if ((spec.get_int_attribute("tiff:subfiletype") & kReducedPage) == 0) continue;
    auto version = versionOf(part, spec, leastSide);
    if (!version || (smallest && smallest->reduction >= version->reduction)) continue;
    version->part.index = page;
    smallest = std::move(version);
  }
  return smallest;
}

}  // namespace

std::optional<SmallerVersion> smallerVersion(ImageReader& reader, const ImagePart& part,
                                             int leastSide) {
  if (part.window != part.stored) return std::nullopt;
  if (reader.kind() == ImageFileKind::openExr) return smallerLevel(reader, part, leastSide);
  if (reader.kind() == ImageFileKind::tiff) return smallerPage(reader, part, leastSide);
  return std::nullopt;
}

}  // namespace cutis
