// Parts of src/app/document/document.h: what is known of single pixels.

#include "core/skin/parameter_buffer.h"
#include "src/app/document/document.h"

namespace cutis {

std::optional<Document::PixelParameters> Document::parametersAt(int x, int y) const {
  if (!scene_ || !scene_->maps.state.bounds().contains(x, y)) return std::nullopt;
  const Rect pixel = {x, y, x + 1, y + 1};
  const auto original = loadParameters(scene_->maps, pixel);
  const auto edited = loadEdited(*scene_, pixel);
  if (!original || !edited || !original.value().present.front()) return std::nullopt;
  PixelParameters parameters;
  for (const Parameter k : kParameters) {
    const auto row = static_cast<std::size_t>(k);
    parameters.original[k] = double{original.value().values[row].front()};
    parameters.edited[k] = double{edited.value().values[row].front()};
  }
  return parameters;
}

std::shared_ptr<const SkinValues> Document::skinOf(const JudgedPixels& pixels,
                                                   const SkinModel& model) {
  return std::make_shared<const SkinValues>(skinValuesOf(pixels, model.profile().axes));
}

std::optional<PlaceSpectra> Document::spectraAt(int x, int y) const {
  return scene_ ? SceneSpectra(*scene_, choice_).at(x, y) : std::nullopt;
}

}  // namespace cutis
