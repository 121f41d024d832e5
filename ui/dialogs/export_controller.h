#pragma once

// Writes the edited albedo where the user chooses, in the background. Interface thread only.

#include <QObject>
#include <QString>

class QWidget;

namespace cutis {

class Document;
class Engine;
class JobRunner;
class ProgressStrip;

class ExportController : public QObject {
  Q_OBJECT

 public:
  // All outlive the controller; dialogs stand before the window.
  ExportController(Document& document, Engine& engine, JobRunner& jobs, ProgressStrip& progress,
                   QWidget* window);

  // Why there is nothing to export, in one sentence; empty if there is.
  QString objection() const;
  // How it went is shown as a message. Precondition, here and below: something is open.
  void exportAlbedo(const QString& path);
  // By a dialog.
  void choose();

 Q_SIGNALS:
  // What was clipped or left out on the way, or why nothing was written.
  void noticed(const QString& sentence, bool isError);

 private:
  Document& document_;
  Engine& engine_;
  JobRunner& jobs_;
  ProgressStrip& progress_;
  QWidget* window_;
};

}  // namespace cutis
