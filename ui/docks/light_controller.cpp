#include "ui/docks/light_controller.h"

#include "src/app/views/view_server.h"
#include "ui/docks/light_panel.h"
#include "ui/view/view_controller.h"

namespace cutis {
namespace {

using Kind = LightChoice::Kind;

ViewKind viewOf(Kind kind) {
  switch (kind) {
    case Kind::ultraviolet:
      return ViewKind::ultraviolet;
    case Kind::nearInfrared:
      return ViewKind::nearInfrared;
    case Kind::colour:
      break;
  }
  return ViewKind::skin;
}

Kind kindOf(ViewKind view) {
  for (const Kind band : {Kind::ultraviolet, Kind::nearInfrared}) {
    if (viewOf(band) == view) return band;
  }
  return Kind::colour;
}

}  // namespace

LightController::LightController(ViewServer& server, ViewController& views, QObject* parent)
    : QObject(parent), server_(server), views_(views) {
  light_.light = QString::fromStdString(server.picture().light);
  light_.observer = QString::fromStdString(server.picture().observer);
  light_.adaptation = server.picture().adaptation;
  connect(&views, &ViewController::currentChanged, this, &LightController::followView);
}

void LightController::attach(LightPanel& panel) {
  panel.setChoice(light_);
  connect(&panel, &LightPanel::changed, this, &LightController::setLight);
  connect(this, &LightController::changed, &panel, &LightPanel::setChoice);
}

void LightController::setLight(const LightChoice& light) {
  LightChoice sameLight = light_;
  sameLight.kind = light.kind;
  const bool choosesLight = light != sameLight;
  if (light != light_) {
    light_ = light;
    Q_EMIT changed(light_);
  }
  if (light.kind == Kind::colour) {
    PictureRequest picture;
    picture.light = light.light.toStdString();
    picture.observer = light.observer.toStdString();
    picture.adaptation = light.adaptation;
    server_.setPicture(picture);
  }
  // Whoever leaves a band without choosing a light goes back to what was seen before it.
  const bool leavesBand = kindOf(views_.current()) != Kind::colour && light.kind == Kind::colour;
  views_.show(leavesBand && !choosesLight ? beforeBand_ : viewOf(light.kind));
}

void LightController::followView() {
  const Kind kind = kindOf(views_.current());
  if (kind == Kind::colour) beforeBand_ = views_.current();
  if (kind == light_.kind) return;
  light_.kind = kind;
  Q_EMIT changed(light_);
}

}  // namespace cutis
