#include "src/app/export/export_target.h"

#include <algorithm>
#include <utility>

#include "core/base/choice_place.h"
#include "src/app/export/overwrite_protection.h"
#include "src/color/color_space.h"
#include "src/files/io/atomic_write.h"
#include "src/images/image_file.h"
#include "src/images/maps/maps_file.h"

namespace cutis {
namespace {

const ColorSpace& usualSpace(SampleType type) {
  return builtInColorSpace(isInteger(type) ? "sRGB" : "Linear Rec.709");
}

// What else holds samples of a type: the next wider one first, then what narrows them least.
std::vector<SampleType> standIns(SampleType type) {
  using enum SampleType;
  switch (type) {
    case uint8:
      return {uint8, uint16, half, float32};
    case uint16:
      return {uint16, float32, half, uint8};
    case half:
      return {half, float32, uint16, uint8};
    default:
      return {float32, uint16, half, uint8};
  }
}

Result<SampleType> sampleTypeFor(const ExportTarget& target, const ImageHeader* image) {
  CUTIS_TRY(types, writableSampleTypes(target.path));
  if (target.sampleType) return *target.sampleType;
  if (image == nullptr) return types.front();
  for (const SampleType type : standIns(image->sourceType)) {
    if (std::find(types.begin(), types.end(), type) != types.end()) return type;
  }
  return types.front();
}

Status checkIsNoInput(const ExportTarget& target) {
  CUTIS_CHECK(checkNotInput(target.path.string(), target.inputs));
  return checkNotInput(target.path.string(), target.sources);
}

}  // namespace

Status checkPictureTarget(const ExportTarget& target) {
  CUTIS_TRY(type, sampleTypeFor(target, nullptr));
  CUTIS_CHECK(checkIsNoInput(target));
  CUTIS_CHECK(checkImageOutput(target.path, type));
  if (!target.colorSpace.empty()) {
    CUTIS_CHECK(canonicalColorSpace(target.colorSpace, kColorSpaceChoice));
  }
  return {};
}

Status checkMapsTarget(const ExportTarget& target) {
  CUTIS_CHECK(checkMapsName(target.path));
  CUTIS_CHECK(checkIsNoInput(target));
  return checkWritable(target.path);
}

Result<PictureEncoding> encodingFor(const ExportTarget& target, const ImageHeader* image,
                                    const ColorSpace& imageSpace, const JobContext& context) {
  CUTIS_TRY(type, sampleTypeFor(target, image));
  PictureEncoding encoding = {type, usualSpace(type)};
  if (!target.colorSpace.empty()) {
    CUTIS_TRY(space, namedColorSpace(target.colorSpace, kColorSpaceChoice));
    // Where two spaces have one name, the file's own goes back to its exact numbers.
    const bool own = image != nullptr && space.name == imageSpace.name;
    encoding.colorSpace = own ? imageSpace : std::move(space);
  } else if (image != nullptr && isInteger(image->sourceType) == isInteger(type) &&
             !image->colors.isConverted && canStateColors(target.path, type, imageSpace)) {
    encoding.colorSpace = imageSpace;
  }
  if (image != nullptr && image->sourceType != type) {
    context.say(target.path.string() + ": the source's samples are " +
                sampleTypeName(image->sourceType) + ", this file's are " + sampleTypeName(type) +
                " in " + encoding.colorSpace.name);
  } else if (image != nullptr && target.colorSpace.empty() &&
             (image->colors.isConverted || encoding.colorSpace.name != imageSpace.name)) {
    context.say(
        target.path.string() + ": the source's colours are " +
        (image->colors.isConverted ? image->colors.statements.front().origin : imageSpace.name) +
        ", this file's are " + encoding.colorSpace.name);
  }
  return encoding;
}

}  // namespace cutis
