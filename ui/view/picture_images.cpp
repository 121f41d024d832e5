#include "ui/view/picture_images.h"

#include <cmath>

#include <QPainter>

#include "ui/view/view_geometry.h"

namespace cutis {
namespace {

constexpr double kSmoothUpTo = 2;

bool contains(const Rect& outer, const Rect& inner) {
  return intersection(outer, inner) == inner;
}

// `image` from image pixel `corner` on, a sample every `step` pixels. Draws the samples in view and
// one more on each side: the far ends of a picture at 64 × lie beyond what the painter's arithmetic
// holds.
void drawSamples(QPainter& painter, const ViewGeometry& geometry, const QImage& image,
                 const QPointF& corner, const QSizeF& step) {
  const QPointF from = geometry.toImage({0, 0}) - corner;
  const QPointF to = geometry.toImage(geometry.middle() * 2) - corner;
  const auto down = [](double x) { return static_cast<int>(std::floor(x)); };
  const QRect seen(QPoint(down(from.x() / step.width()) - 1, down(from.y() / step.height()) - 1),
                   QPoint(down(to.x() / step.width()) + 1, down(to.y() / step.height()) + 1));
  const QRect samples = seen.intersected(image.rect());
  if (samples.isEmpty()) return;
  const auto place = [&](int column, int row) {
    return geometry.toDevice(corner + QPointF(column * step.width(), row * step.height()));
  };
  const QRectF target(place(samples.left(), samples.top()),
                      place(samples.right() + 1, samples.bottom() + 1));
  const bool oneToOne = step.width() * geometry.scale() == 1 && step.height() == step.width();
  if (oneToOne) {
    painter.drawImage(target.topLeft().toPoint(), image, samples);
  } else {
    painter.drawImage(target, image, QRectF(samples));
  }
}

}  // namespace

void PictureImages::draw(QPainter& painter, const ViewGeometry& geometry, const QRect& seen) const {
  if (!geometry.hasPicture()) return;
  const QSizeF picture = geometry.picture();
  // Samples of the last column and row may reach beyond the picture.
  painter.setClipRect(QRectF(geometry.toDevice({0, 0}),
                             geometry.toDevice(QPointF(picture.width(), picture.height())))
                          .intersected(QRectF(seen)));
  const bool detailSuffices = !detail.isNull() && contains(covered, geometry.visible());
  if (!overview.isNull() && !detailSuffices) {
    painter.setRenderHint(QPainter::SmoothPixmapTransform);
    drawSamples(painter, geometry, overview, {0, 0},
                {picture.width() / overview.width(), picture.height() / overview.height()});
  }
  if (!detail.isNull()) {
    const bool smooth = step > 1 || geometry.scale() <= kSmoothUpTo;
    painter.setRenderHint(QPainter::SmoothPixmapTransform, smooth);
    drawSamples(painter, geometry, detail, QPointF(covered.x0, covered.y0),
                {double(step), double(step)});
  }
}

}  // namespace cutis
