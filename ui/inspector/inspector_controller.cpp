#include "ui/inspector/inspector_controller.h"

#include "src/app/document/inspected_place.h"
#include "ui/inspector/inspector_panel.h"
#include "ui/view/view_controller.h"
#include "ui/view/viewport.h"

namespace cutis {

InspectorController::InspectorController(Document& document, JobRunner& jobs, ViewController& views,
                                         Viewport& viewport)
    : document_(document), views_(views), job_(jobs) {
  connect(&viewport, &Viewport::cursorMoved, this, &InspectorController::pointAt);
  connect(&document, &Document::opened, this, &InspectorController::forget);
  connect(&views, &ViewController::adjustmentChanged, this, &InspectorController::refresh);
  for (const auto signal : {&Document::mapsChanged, &Document::sceneReplaced, &Document::fitted})
    connect(&document, signal, this, &InspectorController::refresh);
  connect(&document, &Document::editsChanged, this, &InspectorController::refresh);
  connect(&document, &Document::pinsChanged, this, &InspectorController::refresh);
}

void InspectorController::attach(InspectorPanel& panel) {
  panel_ = &panel;
  panel_->showSentence(tr("Point at the picture"));
}

void InspectorController::setSeen(bool seen) {
  seen_ = seen;
  refresh();
}

void InspectorController::pointAt(int x, int y) {
  pixel_ = QPoint(x, y);
  refresh();
}

void InspectorController::forget() {
  pixel_.reset();
  job_.cancel();
  if (panel_ != nullptr) panel_->showSentence(tr("Point at the picture"));
}

void InspectorController::refresh() {
  if (panel_ == nullptr || !seen_ || !pixel_ || !document_.isOpen()) return;
  ++lookups_;
  InspectedScene shown;
  shown.isImage = document_.scene().source != nullptr && document_.scene().source->image;
  if (const auto skin = document_.skinValues()) shown.skinDifference = skin->medianDeltaE;
  shown.reference = QString::fromStdString(document_.pins().reference);
  shown.adjustment = views_.adjustment();
  job_.request([this, pixel = *pixel_, scene = document_.scene(), choice = document_.fitChoice(),
                pins = document_.pins(), shown](const JobContext&) -> std::function<void()> {
    auto place = inspectPlace(scene, choice, pins, pixel.x(), pixel.y());
    if (!place) return [] {};
    return [this, rows = inspectorRows(place.value(), shown)] { panel_->showRows(rows); };
  });
}

}  // namespace cutis
