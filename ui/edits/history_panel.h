#pragma once

// The steps of the history as a list, oldest first. The current one is marked; those below it are
// undone, and stay until another edit takes their place.

#include <QListWidget>
#include <QStringList>

namespace cutis {

class HistoryPanel : public QListWidget {
  Q_OBJECT

 public:
  explicit HistoryPanel(QWidget* parent = nullptr);

  // `current` is an index into `names`. Silent.
  void setSteps(const QStringList& names, int current);

 Q_SIGNALS:
  // The user wants the state after this step.
  void stepChosen(int step);

 private:
  void choose();

  int current_ = -1;
};

}  // namespace cutis
