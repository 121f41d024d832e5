#pragma once

// Saves a document as a project where the user chooses. Interface thread only.

#include <cstddef>
#include <functional>

#include <QObject>
#include <QString>

#include "src/app/project/project.h"

class QWidget;

namespace cutis {

class Document;
class ProgressStrip;

class SaveController : public QObject {
  Q_OBJECT

 public:
  // All outlive the controller; dialogs stand before the window. view: how the document is looked
  // at, for the project.
  SaveController(Document& document, ProgressStrip& progress, std::function<ProjectView()> view,
                 QWidget* window);

  // Why nothing can be saved, in one sentence; empty if it can.
  QString objection() const;

  // How it went is shown as a message. Asks for a place where the document has none yet.
  void save();
  void saveAs();
  void saveTo(const QString& path);
  // Saves, and then says whether it is saved: not where the user or an error kept it from being.
  void saveThen(std::function<void(bool saved)> then);
  // How many that were begun have failed or were cancelled, so far.
  std::size_t lostCount() const { return lostCount_; }

 private:
  QString choosePlace();
  void end(bool saved);

  Document& document_;
  ProgressStrip& progress_;
  std::function<ProjectView()> view_;
  QWidget* window_;
  std::function<void(bool saved)> then_;
  std::size_t lostCount_ = 0;
};

}  // namespace cutis
