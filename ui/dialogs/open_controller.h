#pragma once

// Asks what is to be opened, and remembers what was. Interface thread only.

#include <filesystem>
#include <vector>

#include <QObject>
#include <QStringList>

#include "src/app/document/document.h"

class QWidget;

namespace cutis {

class CaptureController;
class JobRunner;
class OpenAsDialog;
class ProgressStrip;
struct ImageInspection;

class OpenController : public QObject {
  Q_OBJECT

 public:
  // All outlive the controller; dialogs stand before the window.
  OpenController(JobRunner& jobs, ProgressStrip& progress, QWidget* window);

  void openSample();
  // A capture's folder, capture.json, an image or maps.
  void open(const QString& path);
  // What was dropped or named at once, each as a document of its own; photographs of one scene, or
  // of a folder without capture.json, as one capture, once the user has said how.
  void openAll(const QStringList& paths);
  // By a dialog.
  void chooseCapture();
  void choosePhotographs();
  void chooseImage();
  // An image by a dialog, and then how it is to be read by another.
  void chooseImageAs();
  // Looks at the image in the background, then asks how it is to be read. Only what cannot be
  // opened otherwise, if a sentence says why: then nobody is asked where no choice would help.
  void openAs(const QString& path, const QString& reason = {});

  // What was opened or saved, as it is remembered: the project, or the file of the source. Empty:
  // the sample.
  static QString fileOf(const Document& document);
  // Puts it in front of the recent files.
  void remember(const Document& document);
  // Absolute paths that are still there, newest first.
  QStringList recentFiles() const;

 Q_SIGNALS:
  // An empty path is the embedded sample.
  void openWanted(const std::filesystem::path& path);
  void openAsWanted(const std::filesystem::path& path, const cutis::OpenChoice& choice);

 private:
  // Empty if the user cancels.
  QString chooseFile(const QString& title, const QString& filter);
  // photographs: those of the files that may be one capture; none if they cannot be.
  void openOrAsk(const std::vector<std::filesystem::path>& files,
                 const std::vector<std::filesystem::path>& photographs);
  void ask(const QString& path, const ImageInspection& image, const QString& reason);

  JobRunner& jobs_;
  ProgressStrip& progress_;
  QWidget* window_;
  CaptureController* captures_;
};

// The names of files that were opened are kept no longer.
void forgetRecentFiles();

}  // namespace cutis
