#include "ui/docks/fit_controller.h"

#include <QFileDialog>

#include "ui/docks/fit_panel.h"

namespace cutis {

FitController::FitController(Document& document, QObject* parent)
    : QObject(parent), document_(document) {}

void FitController::attach(FitPanel& panel) {
  connect(&panel, &FitPanel::changed, this, &FitController::fitWith);
  connect(&panel, &FitPanel::fitWanted, this, &FitController::fitAgain);
  connect(&document_, &Document::fitChoiceChanged, &panel, [this, &panel] { showChoice(panel); });
  connect(&document_, &Document::fitted, &panel, &FitPanel::keepProfile);
  for (const auto signal : {&Document::fitted, &Document::sceneReplaced})
    connect(&document_, signal, &panel, [this, &panel] { showExposure(panel); });
  connect(&document_, &Document::networkMissing, &panel, &FitPanel::offerTraining);
}

void FitController::fitWith(const FitChoice& choice) {
  if (document_.canFit()) document_.fitWith(choice);
}

void FitController::fitAgain() {
  if (objection().isEmpty()) document_.fitAgain();
}

QString FitController::objection() const {
  if (!document_.isOpen()) return tr("Nothing is open yet");
  if (!document_.canFit())
    return tr("Maps stay as they were fitted; open their photographs to fit them again");
  if (document_.isFitting()) return tr("The fit is under way");
  return document_.isFitted() ? tr("It is fitted") : QString();
}

void FitController::fitWithProfile(const QString& nameOrPath) {
  FitChoice choice = document_.fitChoice();
  choice.profile = nameOrPath.toStdString();
  fitWith(choice);
}

void FitController::chooseProfile(QWidget& window) {
  const QString file = QFileDialog::getOpenFileName(&window, tr("Load profile"), {},
                                                    tr("Profiles (*.json);;All files (*)"));
  if (!file.isEmpty()) fitWithProfile(file);
}

void FitController::showChoice(FitPanel& panel) const {
  using Subject = FitPanel::Subject;
  const bool isTexture = document_.canFit() && document_.scene().source->image.has_value();
  panel.show(document_.fitChoice(), !document_.canFit() ? Subject::maps
                                    : isTexture         ? Subject::texture
                                                        : Subject::photographs);
  showExposure(panel);
  panel.setFitOffered(objection().isEmpty());
}

void FitController::showExposure(FitPanel& panel) const {
  if (!document_.canFit()) return;
  panel.showExposure(document_.scene().source->measurements.exposure, document_.shareInRange());
}

}  // namespace cutis
