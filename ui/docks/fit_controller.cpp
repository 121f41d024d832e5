#include "ui/docks/fit_controller.h"

#include "ui/docks/fit_panel.h"

namespace cutis {

FitController::FitController(Document& document, FitPanel& panel, QObject* parent)
    : QObject(parent), document_(document), panel_(panel) {
  connect(&panel, &FitPanel::changed, this, &FitController::fitWith);
  connect(&document, &Document::fitChoiceChanged, this, &FitController::showChoice);
  connect(&document, &Document::fitted, &panel, &FitPanel::keepProfile);
  connect(&document, &Document::networkMissing, &panel, &FitPanel::offerTraining);
}

void FitController::fitWith(const FitChoice& choice) {
  if (document_.canFit()) document_.fitWith(choice);
}

void FitController::fitWithProfile(const QString& nameOrPath) {
  FitChoice choice = document_.fitChoice();
  choice.profile = nameOrPath.toStdString();
  fitWith(choice);
}

void FitController::showChoice() {
  using Subject = FitPanel::Subject;
  const bool isTexture = document_.canFit() && document_.scene().source->image.has_value();
  panel_.show(document_.fitChoice(), !document_.canFit() ? Subject::maps
                                     : isTexture         ? Subject::texture
                                                         : Subject::photographs);
}

}  // namespace cutis
