#include "ui/plot/panel_view.h"

#include <QPainter>

#include "src/report/plot/panel_drawing.h"
#include "ui/plot/window_theme.h"

namespace cutis {

const PlotTheme& PanelView::themeFor(const QFont& font) {
  if (!fonts_ || fonts_->font() != font) {
    fonts_ = std::make_unique<PaintFonts>(font);
    theme_ = windowTheme(*fonts_);
    frameKey_ = {};
    frame_ = {};
  }
  return theme_;
}

PanelLayout PanelView::layOut(const Panel& panel, const QRectF& outside, const QFont& font) {
  const PlotTheme& theme = themeFor(font);
  return cutis::layOut(panel, {outside.left(), outside.top(), outside.right(), outside.bottom()},
                       theme, *fonts_);
}

void PanelView::paint(QPainter& painter, const Panel& panel, const QRectF& outside,
                      const QFont& font) {
  const PanelLayout layout = layOut(panel, outside, font);
  FrameKey key = {
      layout, panel.x, panel.y, panel.above, panel.shades, panel.cursor, !panel.message.empty()};
  if (key != frameKey_) {
    frame_ = {};
    drawFrame(frame_, panel, layout, theme_, *fonts_);
    frameKey_ = std::move(key);
  }
  Drawing contents;
  drawContents(contents, panel, layout, theme_, *fonts_);
  cutis::paint(painter, frame_, *fonts_);
  cutis::paint(painter, contents, *fonts_);
}

}  // namespace cutis
