#include "src/app/export/export.h"

#include <mutex>
#include <string>
#include <utility>
#include <vector>

#include "core/render/render_picture.h"
#include "src/app/export/edited_source.h"
#include "src/app/export/picture_encoding.h"
#include "src/images/image_file.h"

namespace cutis {
namespace {

// Shares of the progress.
constexpr double kReadyToWrite = 0.1;
constexpr double kComputed = 0.5;

class Exporter {
 public:
  Exporter(const ExportTarget& target, Engine& engine, std::shared_ptr<TileStore> store,
           const JobContext& context)
      : target_(target), engine_(engine), store_(std::move(store)), context_(context) {}

  Status operator()(const EditedAlbedo& what) const {
    CUTIS_CHECK(checkPictureTarget(target_));
    const ImageHeader* image = what.source->image ? &*what.source->image : nullptr;
    CUTIS_TRY(encoding, encodingFor(target_, image, what.source->colors.followed.space, context_));
    CUTIS_TRY(daylight, pictureRows(PictureRequest(), {}));
    CUTIS_TRY(albedo, engine_.response(what.skin.model, daylight.rows, what.skin.perPixel(),
                                       context_.child(0.0, kReadyToWrite, "preparing")));
    CUTIS_TRY(content,
              editedSource(*what.source, what.skin, *albedo, {encoding.colorSpace, what.pure},
                           store_, context_.child(kReadyToWrite, kComputed, "editing")));
    return write(content, encoding.sampleType);
  }

  Status operator()(const SkinPicture& what) const {
    CUTIS_CHECK(checkPictureTarget(target_));
    CUTIS_TRY(encoding, encodingFor(target_, nullptr, {}, context_));
    CUTIS_TRY(response, engine_.response(what.skin.model, what.picture.rows, what.skin.perPixel(),
                                         context_.child(0.0, kReadyToWrite, "preparing")));
    CUTIS_TRY(linear, renderPicture(what.skin, *response, store_,
                                    context_.child(kReadyToWrite, kComputed, "rendering")));
    CUTIS_TRY(encoded, encodePicture(linear, encoding.colorSpace, store_,
                                     context_.child(kComputed, kComputed)));
    ImageContent content;
    content.channelNames = encoded.size() == 1 ? std::vector<std::string>{"Y"}
                                               : std::vector<std::string>{"R", "G", "B"};
    content.channels = encoded;
    if (what.picture.isColor) content.colorSpace = encoding.colorSpace;
    content.metadata = what.metadata;
    return write(content, encoding.sampleType);
  }

  Status operator()(const MapsFile& what) const {
    CUTIS_CHECK(checkMapsTarget(target_));
    return writeMaps(target_.path, what, context_.child(0.0, 1.0, "writing"));
  }

 private:
  Status write(const ImageContent& content, SampleType type) const {
    return writeImage(target_.path, content, type, context_.child(kComputed, 1.0, "writing"));
  }

  const ExportTarget& target_;
  Engine& engine_;
  std::shared_ptr<TileStore> store_;
  const JobContext& context_;
};

}  // namespace

Status exportTo(const ExportTarget& target, const Exported& what, Engine& engine,
                const std::shared_ptr<TileStore>& store, const JobContext& context) {
  return std::visit(Exporter(target, engine, store, context), what);
}

ExportOutcome exportWithNotes(const ExportTarget& target, const Exported& what, Engine& engine,
                              const std::shared_ptr<TileStore>& store, const JobContext& context) {
  ExportOutcome outcome;
  std::mutex mutex;  // notices come from any thread
  JobContext noting = context;
  noting.notice = [&](const std::string& sentence) {
    const std::scoped_lock lock(mutex);
    outcome.notes.push_back(sentence);
  };
  outcome.status = exportTo(target, what, engine, store, noting);
  return outcome;
}

}  // namespace cutis
