#pragma once

// Joins the layers of a document to the viewport and the layers strip: asks the layer server for
// what is in view, turns it into images, keeps the ranges of the false colours.
//
// Interface thread only.

#include <map>
#include <memory>
#include <vector>

#include <QObject>

#include "src/app/document.h"
#include "src/app/layer_server.h"
#include "ui/layer_image.h"

namespace cutis {

class LayerStrip;
class Viewport;

class LayerController : public QObject {
  Q_OBJECT

 public:
  // All outlive the controller.
  LayerController(Document& document, LayerServer& server, Viewport& viewport, LayerStrip& strip,
                  QObject* parent = nullptr);
  ~LayerController() override;

  LayerKind current() const { return current_; }
  // A layer that the document does not have is ignored.
  void show(LayerKind layer);

 Q_SIGNALS:
  void currentChanged();

 private:
  using Part = std::shared_ptr<const LayerPart>;

  void open();
  bool isOffered(LayerKind layer) const;
  void wantDetail();
  void wantOverview();
  void takeThumbnail(const Part& part);
  void takeRange(const Part& part);
  void showDetail();
  void showOverview();
  void showColorBar();
  QImage imageOf(const LayerPart& part) const;
  bool isNeutral() const;

  Document& document_;
  LayerServer& server_;
  Viewport& viewport_;
  LayerStrip& strip_;
  LayerKind current_ = LayerKind::photograph;
  // Of the unedited maps, so that an edit is seen as a change of colour; of the edited ones where
  // there are no others yet.
  std::map<LayerKind, DisplayRange> ranges_;
  Part detail_;
  Part overview_;
  std::unique_ptr<LayerWatch> detailWatch_;
  std::unique_ptr<LayerWatch> overviewWatch_;
  std::vector<std::unique_ptr<LayerWatch>> thumbnailWatches_;
};

}  // namespace cutis
