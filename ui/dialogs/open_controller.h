#pragma once

// Opens what the user chooses, and remembers it. Interface thread only.

#include <QObject>
#include <QStringList>

class QWidget;

namespace cutis {

class Document;
class JobRunner;
class OpenAsDialog;
class ProgressStrip;
struct ImageInspection;

class OpenController : public QObject {
  Q_OBJECT

 public:
  // All outlive the controller; dialogs stand before the window.
  OpenController(Document& document, JobRunner& jobs, ProgressStrip& progress, QWidget* window);

  void openSample();
  // A capture's folder, capture.json, an image or maps. What cannot be opened is reported and
  // changes nothing.
  void open(const QString& path);
  // What was dropped or named at once: one is opened; of several none, and the user is told why.
  void openAll(const QStringList& paths);
  // By a dialog.
  void chooseCapture();
  void chooseImage();
  // An image by a dialog, and then how it is to be read by another.
  void chooseImageAs();
  // Looks at the image in the background, then asks how it is to be read. Only what cannot be
  // opened otherwise, if a sentence says why: then nobody is asked where no choice would help.
  void openAs(const QString& path, const QString& reason = {});

  // Absolute paths that are still there, newest first.
  QStringList recentFiles() const;

 private:
  void remember();
  void ask(const QString& path, const ImageInspection& image, const QString& reason);

  Document& document_;
  JobRunner& jobs_;
  ProgressStrip& progress_;
  QWidget* window_;
};

}  // namespace cutis
