#pragma once

// Skin as pictures and spectra show it: maps, what is edited of them, and the model they are
// values of.

#include <memory>

#include "core/base/rect.h"
#include "core/base/result.h"
#include "core/edit/edit_stack.h"
#include "core/skin/chromophore_maps.h"
#include "core/skin/model/skin_model.h"
#include "core/skin/parameter_buffer.h"

namespace cutis {

// Cheap to copy: maps and masks are handles, and the maps may still fill. Any thread may read it.
struct EditedSkin {
  std::shared_ptr<const SkinModel> model;
  ChromophoreMaps maps;  // with the constants of the profile that were found per pixel, if any
  EditStack edits;       // masks have the size of the maps

  const ParameterAxes& axes() const { return model->profile().axes; }
  // What each pixel brings along: a response model of this skin asks for the same.
  PerPixel perPixel() const { return maps.perPixel(); }
  int width() const { return maps.width(); }
  int height() const { return maps.height(); }
};

// Parameters of every step-th pixel of every step-th row of rect, with the edits applied.
// Precondition: rect lies within the maps.
Result<ParameterBuffer> loadEdited(const EditedSkin& skin, const Rect& rect, int step = 1);

}  // namespace cutis
