#include "src/app/export/edited_source.h"

#include <bit>
#include <cstdint>
#include <utility>
#include <vector>

#include "core/base/choice_place.h"
#include "core/base/parallel.h"
#include "core/render/render_picture.h"
#include "src/app/open/photograph_part.h"
#include "src/color/color_space.h"
#include "src/images/pixels/alpha.h"

namespace cutis {
namespace {

using Channels = std::vector<std::vector<float>>;  // R, G, B

bool sameBits(float a, float b) {
  return std::bit_cast<std::uint32_t>(a) == std::bit_cast<std::uint32_t>(b);
}

Status convert(const ColorConverter& converter, Channels& channels) {
  const std::size_t pixels = channels.front().size();
  std::vector<float> rgb(3 * pixels);
  for (std::size_t c = 0; c < 3; ++c) {
    for (std::size_t p = 0; p < pixels; ++p)
      rgb[3 * p + c] = channels[c][p];
  }
  CUTIS_CHECK(converter(rgb));
  for (std::size_t c = 0; c < 3; ++c) {
    for (std::size_t p = 0; p < pixels; ++p)
      channels[c][p] = rgb[3 * p + c];
  }
  return {};
}

void multiply(float factor, Channels& channels) {
  if (factor == 1.0f) return;
  for (std::vector<float>& channel : channels) {
    for (float& value : channel)
      value *= factor;
  }
}

// Where no channel of a pixel was changed, its stored values.
void restoreUnchanged(const Channels& before, const Channels& after, const Channels& stored,
                      Channels& result) {
  for (std::size_t p = 0; p < before.front().size(); ++p) {
    const bool changed = !sameBits(before[0][p], after[0][p]) ||
                         !sameBits(before[1][p], after[1][p]) ||
                         !sameBits(before[2][p], after[2][p]);
    if (changed) continue;
    for (std::size_t c = 0; c < 3; ++c)
      result[c][p] = stored[c][p];
  }
}

class SourceEditor {
 public:
  SourceEditor(const Source& source, const EditedSkin& skin, const ResponseModel& albedo,
               const EditedSourceOptions& options)
      : source_(source),
        skin_(skin),
        albedo_(albedo),
        pure_(options.pure),
        exposure_(options.pure ? static_cast<float>(source.measurements.exposure) : 1.0f),
        sameSpace_(source.image && source.colors.followed.space.name == options.colorSpace.name) {}

  void prepare(const ColorSpace& space) {
    fromLinear_ = space.fromLinearRec709;
    if (!source_.image) return;
    toLinear_ = source_.colors.followed.space.toLinearRec709;
    const ImageLayer& layer = source_.image->layer;
    for (const int color : *layer.colors)
      stored_.push_back(source_.image->channels[static_cast<std::size_t>(color)]);
    if (layer.alpha >= 0 && source_.image->alphaKind == AlphaKind::associated) {
      multipliedBy_ = source_.image->channels[static_cast<std::size_t>(layer.alpha)];
    }
  }

  Status editTile(const Rect& rect, std::vector<Plane>& edited) const {
    Channels stored;
    CUTIS_TRY(linear, load(rect, stored));
    multiply(exposure_, linear);
    PictureBuffer part;
    part.channels = linear;
    CUTIS_TRY(changed, editAlbedoPart(std::move(part), skin_, albedo_, pure_, rect, 1));
    Channels result = changed.channels;
    multiply(1.0f / exposure_, result);
    CUTIS_CHECK(convert(fromLinear_, result));
    CUTIS_CHECK(changeByAlpha(multiplyByAlpha, rect, result));
    if (sameSpace_) restoreUnchanged(linear, changed.channels, stored, result);
    for (std::size_t c = 0; c < 3; ++c)
      CUTIS_CHECK(edited[c].store(rect, result[c]));
    return {};
  }

 private:
  // Linear Rec.709, and what the file holds.
  Result<Channels> load(const Rect& rect, Channels& stored) const {
    if (!source_.image) {
      CUTIS_TRY(photographed, photographPart(source_, rect, 1));
      return std::move(photographed.channels);
    }
    stored.assign(3, std::vector<float>(rect.pixelCount()));
    for (std::size_t c = 0; c < 3; ++c)
      CUTIS_CHECK(stored_[c].load(rect, stored[c]));
    Channels linear = stored;
    CUTIS_CHECK(changeByAlpha(divideByAlpha, rect, linear));
    CUTIS_CHECK(convert(toLinear_, linear));
    return linear;
  }

  // Colours of an associated alpha are straight in between.
  template <typename Change>
  Status changeByAlpha(const Change& change, const Rect& rect, Channels& channels) const {
    if (multipliedBy_.empty()) return {};
    std::vector<float> alpha(rect.pixelCount());
    CUTIS_CHECK(multipliedBy_.load(rect, alpha));
    for (std::vector<float>& channel : channels)
      change(channel, alpha);
    return {};
  }

  const Source& source_;
  const EditedSkin& skin_;
  const ResponseModel& albedo_;
  const bool pure_;
  const float exposure_;
  const bool sameSpace_;
  ColorConverter toLinear_;
  ColorConverter fromLinear_;
  std::vector<Plane> stored_;
  Plane multipliedBy_;  // alpha of associated colours
};

// All channels of the source, the three colours replaced.
ImageContent contentOf(const Source& source, const std::vector<Plane>& edited,
                       const ColorSpace& space) {
  ImageContent content;
  content.colorSpace = space;
  content.metadata = source.metadata;
  content.channelNames = {"R", "G", "B"};
  content.channels = edited;
  if (!source.image) return content;
  content.channelNames = source.image->channelNames;
  content.channels = source.image->channels;
  for (std::size_t c = 0; c < 3; ++c)
    content.channels[static_cast<std::size_t>((*source.image->layer.colors)[c])] = edited[c];
  content.alphaKind = source.image->alphaKind;
  content.source = *source.image;
  content.isSourceSpace = source.colors.followed.space.name == space.name;
  content.sourceHash = source.image->contentHash;
  return content;
}

}  // namespace

Result<ImageContent> editedSource(const Source& source, const EditedSkin& skin,
                                  const ResponseModel& albedo, const EditedSourceOptions& options,
                                  const std::shared_ptr<TileStore>& store,
                                  const JobContext& context) {
  SourceEditor editor(source, skin, albedo, options);
  editor.prepare(options.colorSpace);
  std::vector<Plane> edited;
  for (int c = 0; c < 3; ++c) {
    edited.emplace_back(skin.width(), skin.height(), PixelFormat::float32, store);
  }
  CUTIS_CHECK(parallelFor(
      static_cast<std::size_t>(skin.maps.state.tileCount()), context, [&](std::size_t i) {
        return editor.editTile(skin.maps.state.tileRect(static_cast<int>(i)), edited);
      }));
  return contentOf(source, edited, options.colorSpace);
}

}  // namespace cutis
