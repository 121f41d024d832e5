#pragma once

// Writes the edited albedo, and the fitted maps, where the user chooses, in the background.
// Interface thread only.

#include <cstddef>
#include <functional>
#include <vector>

#include <QObject>
#include <QString>

#include "src/app/export/export.h"
#include "src/app/job_runner.h"

class QWidget;

namespace cutis {

class Document;
class ProgressStrip;

class ExportController : public QObject {
  Q_OBJECT

 public:
  // All outlive the controller; dialogs stand before the window.
  ExportController(Document& document, Engine& engine, JobRunner& jobs, ProgressStrip& progress,
                   QWidget* window);

  // Why there is nothing to export, in one sentence; empty if there is.
  QString objection() const;
  QString mapsObjection() const;
  // How it went is shown as a message. Precondition, here and below: something is open.
  void exportAlbedo(const QString& path);
  void exportMaps(const QString& path);
  // By a dialog.
  void choose();
  void chooseMaps();
  bool isExporting() const;
  // How many have ended without their file, so far.
  std::size_t lostCount() const;
  // What is not yet written whole is not written.
  void stop();

 Q_SIGNALS:
  // What was clipped or left out on the way, or why nothing was written.
  void noticed(const QString& sentence, bool isError);

 private:
  // By a dialog; empty if the user cancels. what: "maps.exr"
  QString choosePlace(const QString& title, const QString& what, const QString& filters);
  // what: made in the background.
  void write(const QString& path, const std::function<Result<Exported>()>& what);

  Document& document_;
  Engine& engine_;
  JobRunner& jobs_;
  ProgressStrip& progress_;
  QWidget* window_;
  std::vector<JobId> exports_;  // that were begun
  std::size_t writtenCount_ = 0;
};

}  // namespace cutis
