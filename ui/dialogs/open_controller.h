#pragma once

// Opens what the user chooses, and remembers it. Interface thread only.

#include <QObject>
#include <QStringList>

class QWidget;

namespace cutis {

class Document;
class ProgressStrip;

class OpenController : public QObject {
  Q_OBJECT

 public:
  // All outlive the controller; dialogs stand before the window.
  OpenController(Document& document, ProgressStrip& progress, QWidget* window);

  void openSample();
  // A capture's folder, capture.json, an image or maps. What cannot be opened is reported and
  // changes nothing.
  void open(const QString& path);
  // What was dropped or named at once: one is opened; of several none, and the user is told why.
  void openAll(const QStringList& paths);
  // By a dialog.
  void chooseCapture();
  void chooseImage();

  // Absolute paths that are still there, newest first.
  QStringList recentFiles() const;

 private:
  void remember();

  Document& document_;
  ProgressStrip& progress_;
  QWidget* window_;
};

}  // namespace cutis
