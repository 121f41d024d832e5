#pragma once

// The edited albedo as a picture to write.

#include <memory>
#include <string>

#include "core/base/job_context.h"
#include "core/base/result.h"
#include "core/edit/edit_stack.h"
#include "core/skin/chromophore_maps.h"
#include "core/skin/response_model.h"
#include "src/app/open/source.h"
#include "src/images/image_file.h"

namespace cutis {

struct EditedTextureOptions {
  // Canonical name of the space to write.
  std::string colorSpace;
  // The edited model alone where there is an estimate, instead of the source times the change.
  bool pure = false;
  // The maps were fitted to the source times this; the model alone is divided by it.
  double exposure = 1.0;
};

// The source with editAlbedo() applied (core/render/render_picture.h). Of an albedo texture alpha
// and all further channels, the metadata and, in the source's own colour space, every pixel the
// edits leave alone are what the source holds, to the last bit. Photographs become linear Rec.709
// under D65 first. maps have the size of the source; albedo is their picture under D65.
Result<ImageContent> editedTexture(const Source& source, const ChromophoreMaps& maps,
                                   const EditStack& edits, const ParameterAxes& axes,
                                   const ResponseModel& albedo, const EditedTextureOptions& options,
                                   const std::shared_ptr<TileStore>& store,
                                   const JobContext& context);

}  // namespace cutis
