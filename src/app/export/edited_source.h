#pragma once  // internal to src/app/export

// The edited albedo as a picture to write.

#include <memory>
#include <string>

#include "core/base/job_context.h"
#include "core/base/result.h"
#include "core/render/edited_skin.h"
#include "core/skin/response_model.h"
#include "src/app/open/source.h"
#include "src/images/image_file.h"

namespace cutis {

struct EditedSourceOptions {
  // To write.
  ColorSpace colorSpace;
  // The edited model alone where there is an estimate, instead of the source times the change; in
  // the source's brightness, which its exposure is taken off again for.
  bool pure = false;
};

// The source with editAlbedoPart() applied (core/render/render_picture.h). Of an albedo texture
// alpha and all further channels, the metadata and, in the source's own colour space, every pixel
// the edits leave alone are what the source holds, to the last bit. Photographs become linear
// Rec.709 under D65 first. Precondition: the maps have the size of the source and were fitted at
// its exposure; albedo is their response under D65.
Result<ImageContent> editedSource(const Source& source, const EditedSkin& skin,
                                  const ResponseModel& albedo, const EditedSourceOptions& options,
                                  const std::shared_ptr<TileStore>& store,
                                  const JobContext& context);

}  // namespace cutis
