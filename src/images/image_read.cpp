#include <algorithm>
#include <numeric>

#include "src/images/codec/image_reader.h"
#include "src/images/codec/metadata_access.h"
#include "src/images/color/file_colors.h"
#include "src/images/image_file.h"

namespace cutis {
namespace {

constexpr double kHashShare = 0.05;  // of the time

void fillHeader(const std::filesystem::path& path, const ImagePart& part, ImageFileKind kind,
                ImageHeader& header) {
  header.width = part.width();
  header.height = part.height();
  header.channelNames = part.spec.channelnames;
  header.sourceType = part.type;
  header.colors = fileColors(path, kind, part);
  header.metadata = MetadataAccess::from(part.spec);
}

}  // namespace

int ImageHeader::channelIndex(std::string_view name) const {
  const auto found = std::find(channelNames.begin(), channelNames.end(), name);
  return found == channelNames.end() ? -1 : static_cast<int>(found - channelNames.begin());
}

Result<ImageHeader> readImageHeader(const std::filesystem::path& path, const JobContext& context) {
  CUTIS_TRY(reader, ImageReader::open(path, context));
  CUTIS_TRY(part, reader.part(0));
  ImageHeader header;
  fillHeader(path, part, reader.kind(), header);
  return header;
}

Result<Image> readImage(const std::filesystem::path& path, const ImageReadOptions& options,
                        const std::shared_ptr<TileStore>& store, const JobContext& context) {
  CUTIS_TRY(reader, ImageReader::open(path, context));
  CUTIS_TRY(part, reader.part(0));
  Image image;
  fillHeader(path, part, reader.kind(), image);
  if (options.accept) CUTIS_CHECK(options.accept(image));
  CUTIS_TRY(hash, hashFile(path, context));
  image.contentHash = hash;
  const PixelFormat format = options.format.value_or(
      image.sourceType == SampleType::half ? PixelFormat::half : PixelFormat::float32);
  std::vector<int> all(static_cast<std::size_t>(part.spec.nchannels));
  std::iota(all.begin(), all.end(), 0);
  CUTIS_TRY(planes, reader.read(part, all, format, store, context.child(kHashShare, 1.0)));
  image.channels = std::move(planes);
  return image;
}

}  // namespace cutis
