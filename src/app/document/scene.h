#pragma once

// Everything that pictures of a document are made of, at one moment.

#include <memory>

#include "core/edit/edit_stack.h"
#include "core/skin/chromophore_maps.h"
#include "core/skin/model/skin_model.h"
#include "src/app/open/source.h"

namespace cutis {

// Cheap to copy: maps and masks are handles, and the maps may still fill. Any thread may read it.
struct Scene {
  std::shared_ptr<const SkinModel> model;
  std::shared_ptr<const Source> source;  // null if maps were opened by themselves
  ChromophoreMaps maps;
  EditStack edits;

  int width() const { return maps.width(); }
  int height() const { return maps.height(); }
};

}  // namespace cutis
