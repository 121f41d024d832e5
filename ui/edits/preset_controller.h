#pragma once

// Takes whole sets of edits: presets that come with the editor, files of the user's own, and the
// clipboard, all in one format (src/files/edits/edits_file.h). Each replaces the edits of the
// document in one step of undo. Interface thread only.

#include <QObject>
#include <QString>

#include "src/app/document/document.h"

class QWidget;

namespace cutis {

class ProgressStrip;
class ViewController;

class PresetController : public QObject {
  Q_OBJECT

 public:
  // All outlive the controller; dialogs stand before the window.
  PresetController(Document& document, ViewController& views, ProgressStrip& progress,
                   QWidget* window);

  // Uses one of the catalogue, by its id.
  void useBuiltIn(const QString& id);
  void useFile(const QString& path);
  void saveFile(const QString& path);
  void copy();
  void paste();
  // By a dialog.
  void load();
  void save();

  // Why there is nothing to edit, and why there is nothing to save or copy; empty if there is.
  QString objectionToUse() const;
  QString objectionToKeeping() const;

 private:
  // `name` is what the step of undo is called, `place` what stands in front of errors.
  void use(std::string_view text, const QString& name, const std::string& place);
  void take(const EditStack& edits, const QString& name);
  void fail(const Error& error);

  Document& document_;
  ViewController& views_;
  ProgressStrip& progress_;
  QWidget* window_;
};

}  // namespace cutis
