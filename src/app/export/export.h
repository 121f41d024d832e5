#pragma once

// Writing what a document or a command has made, for window and command line alike: what is
// exported, and to which target.
//
// All files appear as a whole or not at all. Errors are sentences about the target, the source or
// the disk; cancelled if asked to stop.

#include <memory>
#include <string>
#include <variant>
#include <vector>

#include "core/base/job_context.h"
#include "core/base/result.h"
#include "core/base/tile_store.h"
#include "core/render/edited_skin.h"
#include "src/app/engine.h"
#include "src/app/export/export_target.h"
#include "src/app/open/source.h"
#include "src/app/picture_request.h"
#include "src/images/maps/maps_file.h"

namespace cutis {

// The source times what the edits change in the model (src/app/export/edited_source.h).
struct EditedAlbedo {
  EditedSkin skin;
  std::shared_ptr<const Source> source;  // of the size of the maps
  bool pure = false;                     // the edited model alone where there is an estimate
};

// The skin under a light, or the band that the rows are. In a colour space if the rows are colours.
struct SkinPicture {
  EditedSkin skin;
  PictureRows picture;
  ImageMetadata metadata;
};

// A file of maps is one, too.
using Exported = std::variant<EditedAlbedo, SkinPicture, MapsFile>;

// Checks the target and writes.
Status exportTo(const ExportTarget& target, const Exported& what, Engine& engine,
                const std::shared_ptr<TileStore>& store, const JobContext& context);

// The same, its notices collected to be shown with the outcome.
struct ExportOutcome {
  Status status;
  std::vector<std::string> notes;
};
ExportOutcome exportWithNotes(const ExportTarget& target, const Exported& what, Engine& engine,
                              const std::shared_ptr<TileStore>& store, const JobContext& context);

}  // namespace cutis
