#include "src/images/row_preview.h"

#include <algorithm>
#include <chrono>
#include <memory>
#include <optional>
#include <utility>

#include "src/images/preview/image_preview.h"
#include "src/images/preview/preview_layout.h"

namespace cutis {
namespace {

constexpr std::chrono::milliseconds kBetweenLooks{150};

using Clock = std::chrono::steady_clock;

struct RowPreview {
  RowPreview(const CanvasLayout& layout, ColorConverter toLinear)
      : canvas(layout, std::move(toLinear)) {}

  PreviewCanvas canvas;
  std::optional<Clock::time_point> shown = {};
};

}  // namespace

RowsSeen rowPreview(const ImagePart& part, const ImageLayer& layer, const FileColors& colors,
                    const PreviewSink& sink, const JobContext& context) {
  const int step =
      reductionOf(std::max(part.window.width(), part.window.height()), sink.options.leastSide);
  const auto layout = canvasLayout(part, layer, step);
  const auto decision = decideColors(colors, sink.options.colorSpace, {});
  if (step == 1 || colors.isConverted || !layout || !decision) return {};
  const auto preview =
      std::make_shared<RowPreview>(*layout, decision.value().followed.space.toLinearRec709);
  return [preview, &sink, samples = rowSamples(part), end = part.stored.y1, stop = context.stop](
             std::span<const std::byte> rows, int y0, int y1) {
    preview->canvas.add(samples, rows, y0);
    const auto now = Clock::now();
    if (preview->shown && now - *preview->shown < kBetweenLooks && y1 < end) return;
    auto picture = preview->canvas.picture(PreviewCanvas::Gaps::empty, {stop, {}, {}});
    if (picture) sink.show(*std::move(picture));
    preview->shown = now;
  };
}

}  // namespace cutis
