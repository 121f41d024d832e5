#include "ui/plot/drawing_pages.h"

#include <cmath>

#include <QBuffer>
#include <QMarginsF>
#include <QPageSize>
#include <QPainter>
#include <QPdfWriter>

#include "ui/plot/paint_drawing.h"

namespace cutis {
namespace {

constexpr double kPixelsPerInch = 96.0;
constexpr double kPointsPerInch = 72.0;
constexpr int kPdfResolution = 1200;

QFont drawingFont() {
  QFont font("DejaVu Sans");
  font.setPixelSize(12);
  return font;
}

}  // namespace

QByteArray pdfOf(const Drawing& drawing) {
  QBuffer bytes;
  bytes.open(QIODevice::WriteOnly);
  QPdfWriter writer(&bytes);
  writer.setResolution(kPdfResolution);
  writer.setTitle(QString::fromStdString(drawing.title));
  writer.setCreator("Cutis");
  const QSizeF points = QSizeF(drawing.width, drawing.height) * kPointsPerInch / kPixelsPerInch;
  writer.setPageSize(QPageSize(points, QPageSize::Point, {}, QPageSize::ExactMatch));
  writer.setPageMargins(QMarginsF());
  QPainter painter;
  if (!painter.begin(&writer)) return {};
  painter.scale(kPdfResolution / kPixelsPerInch, kPdfResolution / kPixelsPerInch);
  paint(painter, drawing, PaintFonts(drawingFont()));
  painter.end();
  return bytes.data();
}

QImage imageOf(const Drawing& drawing, double scale) {
  const QSizeF size = QSizeF(drawing.width, drawing.height) * scale;
  QImage image(static_cast<int>(std::lround(size.width())),
               static_cast<int>(std::lround(size.height())), QImage::Format_RGB32);
  image.fill(Qt::white);
  QPainter painter(&image);
  painter.scale(scale, scale);
  paint(painter, drawing, PaintFonts(drawingFont()));
  return image;
}

}  // namespace cutis
