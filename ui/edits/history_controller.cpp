#include "ui/edits/history_controller.h"

#include "ui/edits/history_panel.h"

namespace cutis {

HistoryController::HistoryController(Document& document, HistoryPanel& panel, QObject* parent)
    : QObject(parent), document_(document), panel_(panel) {
  connect(&document, &Document::opened, this, &HistoryController::showSteps);
  connect(&document, &Document::editsChanged, this, &HistoryController::showSteps);
  // After the click that chose it.
  connect(
      &panel, &HistoryPanel::stepChosen, this,
      [this](int step) { document_.goToStep(static_cast<std::size_t>(step)); },
      Qt::QueuedConnection);
  showSteps();
}

void HistoryController::showSteps() {
  const UndoHistory& history = document_.history();
  QStringList names = {tr("Opened")};
  for (std::size_t step = 1; step < history.stepCount(); ++step)
    names << history.stepName(step);
  panel_.setSteps(names, static_cast<int>(history.position()));
}

}  // namespace cutis
