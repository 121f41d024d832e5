#pragma once

// The line at the foot of the window: the running job with its cancel button, a message, and the
// read-out under the cursor on the right. Escape dismisses the message; it stops no job, as people
// press it for much else. Errors stay until they are dismissed; notices go after ten seconds. What
// has no room is shortened: the strip never widens the window. Interface thread only.

#include <list>
#include <optional>

#include <QElapsedTimer>
#include <QString>
#include <QTimer>
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

  // The newest stands in front, but an error that nobody could read yet stands before notices. A
  // notice that gives way to another message after it has stood long enough to be read does not
  // return; an error does until it is dismissed or another error has come. Of one topic, such as
  // the name of a job, the newest message alone is kept; an empty topic is none.
  void showMessage(const QString& text, bool isError, const QString& topic = {});
  void clearMessages();
  // What was said about the topic no longer holds.
  void withdraw(const QString& topic);
  // What is shown; empty if nothing.
  QString message() const;
  bool messageIsError() const;
  // False: messages are shown by somebody else; Escape still dismisses them.
  void setMessagesShown(bool shown);
  // How long a notice is shown, instead of ten seconds.
  void setNoticeLife(int ms);

  void setReadout(const QString& text);

 Q_SIGNALS:
  void cancelWanted();
  // Another message is to be shown, or none any more.
  void messageChanged();

 private:
  struct Message {
    QString text;
    bool isError;
    QString topic;
  };

  // Null if there is none.
  const Message* current() const;
  // The topic of a message that is said again without one.
  QString topicOf(const QString& text) const;
  bool currentIsRead() const;
  void dismiss();
  void showCurrent();
  void updateEscape();

  ElidedLabel* job_;
  QProgressBar* bar_;
  QToolButton* cancel_;
  QLabel* messageMark_;
  ElidedLabel* message_;
  QToolButton* dismiss_;
  ElidedLabel* readout_;
  QShortcut* escape_;

  bool jobRuns_ = false;
  bool messagesShown_ = true;
  std::list<Message> messages_;  // the last is shown
  QElapsedTimer shownFor_;
  QTimer age_;  // of the notice that is shown
};

// "3 s left", "2 min left"; "less than 1 s left" below one second.
QString timeLeftText(double seconds);

}  // namespace cutis
