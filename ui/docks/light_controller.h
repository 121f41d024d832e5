#pragma once

// Under which light the skin is shown: joins the light panel to the view of the skin and to those
// of the bands outside the visible. Interface thread only.

#include <QObject>

#include "src/app/views/view_part.h"
#include "ui/docks/light_choice.h"

namespace cutis {

class LightPanel;
class ViewController;
class ViewServer;

class LightController : public QObject {
  Q_OBJECT

 public:
  // Both outlive the controller.
  LightController(ViewServer& server, ViewController& views, QObject* parent = nullptr);

  // From now on the panel shows the light and chooses one.
  void attach(LightPanel& panel);

  const LightChoice& light() const { return light_; }
  // Shows the skin under the light, or the view of the band. From a band back to colour with the
  // light as it was, the view that was shown before it.
  void setLight(const LightChoice& light);

 Q_SIGNALS:
  // By setLight() or because another view is shown.
  void changed(const cutis::LightChoice& light);

 private:
  void followView();

  ViewServer& server_;
  ViewController& views_;
  LightChoice light_;
  ViewKind beforeBand_ = ViewKind::skin;  // the last view that is none of a band
};

}  // namespace cutis
