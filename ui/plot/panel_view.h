#pragma once  // internal to ui/plot

// A panel of src/report in a widget: laid out in the window's theme and painted. What changes
// seldom, the axes with their numbers, is kept from one time to the next. Interface thread only.

#include <memory>

#include <QRectF>

#include "src/report/plot/panel_layout.h"
#include "ui/plot/paint_drawing.h"

namespace cutis {

class PanelView {
 public:
  // The window's theme for a font. Valid until another font is asked for.
  const PlotTheme& themeFor(const QFont& font);

  PanelLayout layOut(const Panel& panel, const QRectF& outside, const QFont& font);
  void paint(QPainter& painter, const Panel& panel, const QRectF& outside, const QFont& font);

 private:
  // All that the frame is made of.
  struct FrameKey {
    PanelLayout layout;
    Axis x, y;
    std::vector<Tick> above;
    std::vector<Shade> shades;
    std::optional<Tick> cursor;
    bool hasMessage = false;

    bool operator==(const FrameKey&) const = default;
  };

  std::unique_ptr<PaintFonts> fonts_;
  PlotTheme theme_;
  FrameKey frameKey_;
  Drawing frame_;
};

}  // namespace cutis
