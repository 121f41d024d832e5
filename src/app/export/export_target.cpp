#include "src/app/export/export_target.h"

#include <algorithm>

#include "src/app/export/overwrite_protection.h"
#include "src/color/color_space.h"
#include "src/files/io/atomic_write.h"
#include "src/images/image_file.h"
#include "src/images/maps/maps_file.h"

namespace cutis {
namespace {

constexpr char kSpacePlace[] = "--colorspace";

std::string usualSpace(SampleType type) {
  return isInteger(type) ? "sRGB" : "Linear Rec.709";
}

Result<SampleType> sampleTypeFor(const ExportTarget& target, const ImageHeader* image) {
  CUTIS_TRY(types, writableSampleTypes(target.path));
  if (target.sampleType) return *target.sampleType;
  const bool holdsOwn =
      image != nullptr && std::find(types.begin(), types.end(), image->sourceType) != types.end();
  return holdsOwn ? image->sourceType : types.front();
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
    CUTIS_CHECK(canonicalColorSpace(target.colorSpace, kSpacePlace));
  }
  return {};
}

Status checkMapsTarget(const ExportTarget& target) {
  CUTIS_CHECK(checkMapsName(target.path));
  CUTIS_CHECK(checkIsNoInput(target));
  return checkWritable(target.path);
}

Result<PictureEncoding> encodingFor(const ExportTarget& target, const ImageHeader* image,
                                    const std::string& imageSpace, const JobContext& context) {
  CUTIS_TRY(type, sampleTypeFor(target, image));
  PictureEncoding encoding = {type, usualSpace(type)};
  if (!target.colorSpace.empty()) {
    CUTIS_TRY(space, canonicalColorSpace(target.colorSpace, kSpacePlace));
    encoding.colorSpace = space;
  } else if (image != nullptr && isInteger(image->sourceType) == isInteger(type)) {
    encoding.colorSpace = imageSpace;
  }
  if (image != nullptr && image->sourceType != type) {
    context.say(target.path.string() + ": the source's samples are " +
                sampleTypeName(image->sourceType) + ", this file's are " + sampleTypeName(type) +
                " in " + encoding.colorSpace);
  }
  return encoding;
}

}  // namespace cutis
