#pragma once

// Joins the views of a document to the viewport and the strip of views: asks the view server for
// what is in view, turns it into images, keeps the ranges of the false colours.
//
// Interface thread only.

#include <map>
#include <memory>
#include <set>
#include <vector>

#include <QObject>

#include "src/app/document/document.h"
#include "src/app/views/view_server.h"
#include "ui/color/color_bar.h"
#include "ui/color/display_curve.h"
#include "ui/view/view_image.h"

namespace cutis {

class ViewStrip;
class Viewport;

class ViewController : public QObject {
  Q_OBJECT

 public:
  // All outlive the controller.
  ViewController(Document& document, ViewServer& server, Viewport& viewport,
                 QObject* parent = nullptr);
  ~ViewController() override;

  // From now on the strip, which outlives the controller, shows the views and chooses one. At most
  // one strip.
  void attach(ViewStrip& strip);
  // Whether anybody sees the strip. While nobody does, of its thumbnails none is made but the one
  // that gives the false colours of the current view their range. At first nobody does.
  void setStripSeen(bool seen);

  ViewKind current() const { return current_; }
  // Whether the document has such a view.
  bool isOffered(ViewKind view) const;
  // A view that the document does not have is ignored.
  void show(ViewKind view);

  // The range of the current map: back from what was drawn to the usual one, and its scale.
  void makeRangeAutomatic();
  bool isRangeAutomatic() const { return !fixed_.contains(current_); }
  // Whether the current view is a map that is complete.
  bool canBeLogarithmic() const;
  bool isLogarithmic() const { return logarithmic_.contains(current_); }
  void setLogarithmic(bool isLogarithmic);

  // Of views in colours; thumbnails stay as they are.
  const ViewAdjustment& adjustment() const { return adjustment_; }
  void setAdjustment(const ViewAdjustment& adjustment);

  // What is hatched over views in false colours.
  bool isMarked(PixelMark mark) const { return (marks_ & mark) != 0; }
  void setMarked(PixelMark mark, bool on);

  // What is shown now; null until it was made. The overview is the whole picture.
  const std::shared_ptr<const ViewPart>& detail() const { return detail_; }
  const std::shared_ptr<const ViewPart>& overview() const { return overview_; }
  // What is asked for them.
  ViewRequest detailRequest() const;
  ViewRequest overviewRequest() const;
  // A part of a view as this window shows it: its range and scale, or the adjustment.
  QImage imageOf(const ViewPart& part) const;
  // A colour bar in place of the current view's own; none: that one again.
  void setBarInstead(const std::optional<ColorBarSpec>& spec);

  // The whole picture as it was first seen, small; null until it is.
  const QImage& firstPicture() const { return firstPicture_; }

 Q_SIGNALS:
  void firstPictureSeen();
  // One of detail() and overview() is another.
  void partShown();
  void currentChanged();
  void rangeChanged();
  void adjustmentChanged();

 private:
  using Part = std::shared_ptr<const ViewPart>;

  void open();
  // While nothing is open.
  void showPreview(const SourcePreview& preview);
  void refinePreview(const SourcePreview& preview);
  void endPreview();
  bool awaitsEstimate(ViewKind view) const;
  void fillStrip();
  // The whole picture with at most `size` samples a side.
  ViewRequest wholePicture(ViewKind view, int size) const;
  PixelMarks wantedMarks() const;
  void refillStrip();
  std::vector<ViewKind> offeredViews() const;
  void showBand();
  void watchThumbnails();
  void wantDetail();
  void wantOverview();
  void takeThumbnail(const Part& part);
  // In the strip.
  void showThumbnail(ViewKind view);
  void takeRange(const Part& part);
  // Null for what is no map, and while there is no complete one.
  const std::vector<float>* skinValuesOf(ViewKind view) const;
  void takeSkinValues();
  const DisplayRange* knownRange(ViewKind view) const;  // null: none
  void showRange();
  void showDetail();
  void showOverview();
  void showColorBar();
  // What the scale of the current view leaves open; empty: nothing.
  QString stateText() const;
  QImage imageOf(const ViewPart& part, const DisplayCurve& curve) const;

  Document& document_;
  ViewServer& server_;
  Viewport& viewport_;
  ViewStrip* strip_ = nullptr;
  ViewKind current_ = ViewKind::photograph;
  std::vector<ViewKind> offered_;  // in the strip
  // Ranges of the unedited maps, so that an edit is seen as a change of colour; of the edited ones
  // where there are no others yet.
  std::map<ViewKind, DisplayRange> ranges_;
  std::map<ViewKind, DisplayRange> fixed_;  // that the user has drawn
  std::set<ViewKind> logarithmic_;
  PixelMarks marks_ = 0;
  std::optional<ColorBarSpec> barInstead_;
  ViewAdjustment adjustment_;
  DisplayCurve curve_;  // of the adjustment
  Part detail_;
  Part overview_;
  std::map<ViewKind, Part> thumbnails_;
  QImage preview_;  // null: none is shown
  QImage firstPicture_;
  std::unique_ptr<ViewWatch> detailWatch_;
  std::unique_ptr<ViewWatch> overviewWatch_;
  bool stripSeen_ = false;
  std::map<ViewKind, std::unique_ptr<ViewWatch>> thumbnailWatches_;
};

}  // namespace cutis
