#pragma once

// The line at the foot of the window: the running job with its cancel button, a message that stays
// until it is dismissed, and the read-out under the cursor on the right. Escape cancels the job; if
// none runs it dismisses the message. Interface thread only.

#include <optional>

#include <QString>
#include <QStringList>
#include <QWidget>

class QLabel;
class QProgressBar;
class QShortcut;
class QToolButton;

namespace cutis {

class ElidedLabel;

struct JobState {
  QString name;                       // "Fitting"
  QString stage;                      // "haemoglobin"; may be empty
  std::optional<double> fraction;     // [0, 1] done; unknown shows a moving bar
  std::optional<double> secondsLeft;  // not shown while unknown
};

class ProgressStrip : public QWidget {
  Q_OBJECT

 public:
  explicit ProgressStrip(QWidget* parent = nullptr);

  void setJob(const JobState& job);
  // No job runs.
  void clearJob();
  bool jobRuns() const { return jobRuns_; }

  // Errors stand before notices, newer ones before older; a dismissed one gives way to the next.
  void showMessage(const QString& text, bool isError);
  void clearMessages();
  // What is shown; empty if nothing.
  QString message() const;

  void setReadout(const QString& text);

 Q_SIGNALS:
  void cancelWanted();

 private:
  void dismiss();
  void showCurrent();
  void updateEscape();

  ElidedLabel* job_;
  QProgressBar* bar_;
  QToolButton* cancel_;
  QLabel* messageMark_;
  ElidedLabel* message_;
  QToolButton* dismiss_;
  QLabel* readout_;
  QShortcut* escape_;

  bool jobRuns_ = false;
  QStringList errors_;
  QStringList notices_;
};

// "3 s left", "2 min left"; "less than 1 s left" below one second.
QString timeLeftText(double seconds);

}  // namespace cutis
