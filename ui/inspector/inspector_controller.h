#pragma once

// Joins the cursor to the inspector: what is known of the pixel under it is looked up in the
// background, while somebody sees the panel. The last pixel stays when the cursor leaves.
// Interface thread only.

#include <optional>

#include <QObject>
#include <QPoint>

#include "src/app/document/document.h"
#include "src/app/latest_job.h"

namespace cutis {

class InspectorPanel;
class ViewController;
class Viewport;

class InspectorController : public QObject {
  Q_OBJECT

 public:
  // All outlive the controller.
  InspectorController(Document& document, JobRunner& jobs, ViewController& views,
                      Viewport& viewport);

  void attach(InspectorPanel& panel);
  // At first nobody sees it.
  void setSeen(bool seen);
  // How many places have been looked up.
  int lookups() const { return lookups_; }

 private:
  void pointAt(int x, int y);
  void forget();
  void refresh();

  Document& document_;
  ViewController& views_;
  LatestJob job_;
  InspectorPanel* panel_ = nullptr;
  bool seen_ = false;
  int lookups_ = 0;
  std::optional<QPoint> pixel_;
};

}  // namespace cutis
