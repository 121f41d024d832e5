#pragma once

// What is open, read in another way: with a mask or without, or as a dialog says. Its edits are
// kept. Interface thread only.

#include <filesystem>

#include <QObject>
#include <QString>

class QWidget;

namespace cutis {

class Document;
class JobRunner;
class NoticeBar;
class ProgressStrip;
struct ImageInspection;

class ReopenController : public QObject {
  Q_OBJECT

 public:
  // All outlive the controller; dialogs stand before the window. A mask that lies beside what was
  // opened is offered in the notice, once.
  ReopenController(Document& document, JobRunner& jobs, ProgressStrip& progress, NoticeBar& notice,
                   QWidget* window);

  // Why it cannot be, in one sentence; empty if it can.
  QString maskObjection() const;
  QString removeObjection() const;
  QString interpretObjection() const;

  // By a dialog of files.
  void chooseMask();
  // An empty path takes the mask away.
  void useMask(const std::filesystem::path& mask);
  // Layer, colour space, exposure and mask by a dialog, as they are now.
  void interpret();

  // Asks whether a file that was dropped is the mask of this picture, where its name says that it
  // may be; otherwise nothing happens. Whether it asks.
  bool askWhetherMask(const std::filesystem::path& dropped);

 Q_SIGNALS:
  // What was dropped is a picture of its own.
  void pictureWanted(const QString& path);

 private:
  void offerMaskBeside();
  void ask(const ImageInspection& image);

  Document& document_;
  JobRunner& jobs_;
  ProgressStrip& progress_;
  NoticeBar& notice_;
  QWidget* window_;
};

}  // namespace cutis
