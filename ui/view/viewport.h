#pragma once

// The view of the picture. It shows what it is given and says what it needs: after viewChanged the
// owner computes the visible pixels at that step and hands them back by setDetail. Until they come
// the overview, stretched, stands in, so that panning and zooming never wait.
//
// Markers can be dragged; a press on one, with any button but the middle one, selects it.
//
// The arrow keys pan, and so do space and drag, or the middle button; the wheel zooms about the
// cursor. While the cursor is over the view space is held for it, whatever has the keyboard, unless
// that is a field of text. The line of a wipe is dragged, or moved with shift and the arrow keys.
// Interface thread only.

#include <optional>
#include <utility>

#include <QImage>
#include <QPoint>
#include <QWidget>

#include "core/base/rect.h"
#include "ui/color/color_bar.h"
#include "ui/view/band_scrubber.h"
#include "ui/view/hatching.h"
#include "ui/view/picture_images.h"
#include "ui/view/picture_marker.h"
#include "ui/view/picture_split.h"
#include "ui/view/view_geometry.h"

namespace cutis {

class ColorBarControl;

class Viewport : public QWidget {
  Q_OBJECT

 public:
  static constexpr double kZoomPerNotch = 1.25;  // of a wheel; a touchpad sends fractions of one

  explicit Viewport(QWidget* parent = nullptr);

  // The size in image pixels. Drops the images of the picture before and fits the new one.
  void setPictureSize(int width, int height);
  // The whole picture at any resolution. QImage::Format_RGB32 draws fastest, here and below.
  void setOverview(const QImage& image);
  // The pixels of `covered`, in image pixels, one sample of `image` per `step` pixels.
  void setDetail(const QImage& image, const Rect& covered, int step);
  // No picture.
  void clear();

  // A second picture of the same place, shared with as `mode` says; the line of a wipe stays where
  // it was. What is hatched and the colour bar are of the first.
  void setSplit(SplitMode mode, const QString& firstName, const QString& secondName);
  SplitMode splitMode() const { return split_.mode; }
  // As setOverview() and setDetail(), of the second picture.
  void setSecondOverview(const QImage& image);
  void setSecondDetail(const QImage& image, const Rect& covered, int step);
  void clearSecond();
  // Where the line of a wipe is, as a share of the width.
  double wipePosition() const { return split_.position; }
  // What is seen of the picture, with all that lies over it.
  QImage picture();

  // A bar in the lower left corner; nothing hides it.
  const std::optional<ColorBarSpec>& colorBar() const;
  void setColorBar(const std::optional<ColorBarSpec>& spec);

  // Hatched over the picture, in pixels of the screen.
  void setMarks(const MarkedSamples& marks);
  // Beside the bar, where it is wanted.
  BandScrubber& bandScrubber() { return *bandScrubber_; }
  const BandScrubber& bandScrubber() const { return *bandScrubber_; }
  // Above the picture.
  const QVector<PictureMarker>& markers() const { return markers_; }
  void setMarkers(const QVector<PictureMarker>& markers);

  // A few words in the middle of the picture, for what is not there to be seen yet; empty: none.
  void setNotice(const QString& notice);
  const QString& notice() const { return notice_; }

  // Device pixels per image pixel.
  double zoom() const { return geometry_.scale(); }
  bool fitted() const { return geometry_.fitted(); }
  // The image point in the middle of the view.
  QPointF middle() const { return geometry_.toImage(geometry_.middle()); }
  // Brings an image point into the middle, at this zoom; of a view that was never laid out once it
  // is.
  void showPlace(const QPointF& image, double zoom);
  // As viewChanged last reported; empty without a picture.
  Rect visibleRect() const { return geometry_.visible(); }
  int samplingStep() const { return geometry_.step(); }
  // These convert between image pixels and the widget's device-independent ones.
  QPointF toWidget(const QPointF& image) const;
  QPointF toImage(const QPointF& widget) const;

 public Q_SLOTS:
  void fitPicture();
  // About the cursor if it is over the view, else about the middle.
  void zoomOneToOne();
  void zoomBy(double factor);
  // By one notch of the wheel.
  void zoomIn();
  void zoomOut();

 Q_SIGNALS:
  // The pixels in view (cut to the picture; empty if it is out of view) and the largest sampling
  // step that gives a sample for every device pixel. Only when one of the two has changed, or there
  // is another picture.
  void viewChanged(const cutis::Rect& visible, int step);
  // Image pixel under the cursor; cursorLeft once when it leaves the picture.
  void cursorMoved(int x, int y);
  void cursorLeft();
  // Left button pressed and released on one spot of the picture, where no marker is.
  void clicked(int x, int y);
  // The user has drawn the colour bar to another range, or wants the usual one again.
  void rangeMoved(const cutis::DisplayRange& range);
  void automaticRangeWanted();
  void markerPressed(int marker);
  // It is being dragged, and is on this pixel now; setMarkers() moves it.
  void markerDragged(int marker, int x, int y);

 protected:
  void paintEvent(QPaintEvent* event) override;
  void resizeEvent(QResizeEvent* event) override;
  void wheelEvent(QWheelEvent* event) override;
  void mousePressEvent(QMouseEvent* event) override;
  void mouseMoveEvent(QMouseEvent* event) override;
  void mouseReleaseEvent(QMouseEvent* event) override;
  void leaveEvent(QEvent* event) override;
  void hideEvent(QHideEvent* event) override;
  void keyPressEvent(QKeyEvent* event) override;
  void keyReleaseEvent(QKeyEvent* event) override;
  void focusInEvent(QFocusEvent* event) override;
  void focusOutEvent(QFocusEvent* event) override;
  void changeEvent(QEvent* event) override;
  bool eventFilter(QObject* watched, QEvent* event) override;

 private:
  void setSpaceHeld(bool held);
  std::optional<QPoint> pixelAt(const QPointF& widget) const;
  std::optional<int> markerUnder(const QPointF& widget) const;
  void dragMarker(const QPointF& widget);
  QPointF anchor() const;
  void placeControls();
  void viewMoved();
  void updateCursor();
  void updateShape();
  void drawNotice(QPainter& painter) const;
  void drawHatching(QPainter& painter);
  void drawMarkersOnPanes(QPainter& painter);
  void moveLine(double x);
  void layOut();

  ViewGeometry geometry_;
  PictureImages images_;
  PictureSplit split_;
  MarkedSamples marks_;
  QImage hatching_;  // over the whole view; null: of another place or time
  ColorBarControl* colorBar_;
  BandScrubber* bandScrubber_;
  QVector<PictureMarker> markers_;
  QString notice_;

  Rect toldVisible_;
  int toldStep_ = 0;

  std::optional<QPointF> cursor_;   // device-independent, while over the widget
  std::optional<QPointF> grabbed_;  // where the picture was last dragged to
  std::optional<QPointF> pressed_;  // where a click may end
  bool wiping_ = false;             // the line of the wipe is held
  std::optional<int> dragged_;      // a marker
  bool cursorOnPicture_ = false;
  bool spaceHeld_ = false;
  bool showFocus_ = false;
  std::optional<std::pair<QPointF, double>> placeToShow_;  // once there is a size
};

}  // namespace cutis
