#pragma once

// Training of a network as it is seen: progress, the errors epoch by epoch, and at the end how far
// off the networks are. Modeless; closing it while it trains cancels. Interface thread only.

#include <QDialog>

#include "src/app/training/network_errors.h"
#include "src/app/training/network_training.h"
#include "ui/plot/loss_plot.h"

class QLabel;
class QProgressBar;
class QPushButton;

namespace cutis {

class ErrorTable;

class TrainingDialog : public QDialog {
  Q_OBJECT

 public:
  explicit TrainingDialog(QWidget* parent = nullptr);

  // A training begins: what for, and how many epochs it has.
  void begin(const QString& rig, const QString& profile, const NetworkTraining& training);
  // The stage in the words of the job. Negative seconds are unknown.
  void showProgress(const QString& stage, double fraction, double secondsLeft);
  void addEpoch(const NetworkEpoch& epoch);
  void showResult(const NetworkErrors& errors, double seconds);
  // One sentence each.
  void showFailure(const QString& sentence);
  void showSaved(const QString& sentence, bool failed);

  bool isTraining() const { return training_; }

  void reject() override;

 Q_SIGNALS:
  void cancelWanted();
  void useWanted();
  void saveWanted();

 private:
  void addButtons();
  void setStatus(const QString& sentence, bool isError);
  void showButtons(bool training, bool trained);

  bool training_ = false;
  std::vector<LossCurve> curves_;
  QLabel* heading_;
  LossPlot* plot_;
  QProgressBar* bar_;
  QLabel* status_;
  ErrorTable* errors_;
  QPushButton* use_;
  QPushButton* save_;
  QPushButton* cancel_;
};

}  // namespace cutis
