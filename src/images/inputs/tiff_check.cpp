#include "src/images/inputs/tiff_check.h"

#include <algorithm>
#include <cstddef>
#include <utility>

#include "src/images/inputs/tiff_directory.h"

namespace cutis {
namespace {

constexpr int kStripOffsets = 273;
constexpr int kStripByteCounts = 279;
constexpr int kTileOffsets = 324;
constexpr int kTileByteCounts = 325;

}  // namespace

Status checkTiffExtent(const std::filesystem::path& path) {
  const auto cutOff = [&] {
    return inputError(path.string(), "the TIFF file is cut off; get a complete copy");
  };
  TiffDirectory file(path);
  for (const auto& [offsetTag, countTag] :
       {std::pair{kStripOffsets, kStripByteCounts}, std::pair{kTileOffsets, kTileByteCounts}}) {
    const auto offsetField = file.find(offsetTag), countField = file.find(countTag);
    // Very old files have no byte counts; libtiff then works them out.
    if (!offsetField || !countField) continue;
    const auto offsets = file.values(*offsetField), counts = file.values(*countField);
    if (!offsets || !counts) return cutOff();
    for (std::size_t i = 0; i < std::min(offsets->size(), counts->size()); ++i) {
      if ((*offsets)[i] > file.fileLength() || (*counts)[i] > file.fileLength() - (*offsets)[i]) {
        return cutOff();
      }
    }
  }
  return {};
}

}  // namespace cutis
