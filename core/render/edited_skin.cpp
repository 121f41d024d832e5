#include "core/render/edited_skin.h"

namespace cutis {

Result<ParameterBuffer> loadEdited(const EditedSkin& skin, const Rect& rect, int step) {
  CUTIS_TRY(parameters, loadParameters(skin.maps, rect, step));
  CUTIS_CHECK(applyEdits(skin.edits, skin.axes(), rect, step, parameters));
  return parameters;
}

}  // namespace cutis
