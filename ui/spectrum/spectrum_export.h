#pragma once

// Takes what the spectrum dock shows out of the program: curves, figure and table of pins as files
// and on the clipboard, and how it all came about as text. Files are written in the background by
// the one function that writes files. Interface thread only.

#include <functional>

#include <QObject>
#include <QString>

#include "core/base/result.h"
#include "src/app/job_runner.h"
#include "src/report/drawing.h"

class QWidget;

namespace cutis {

class Document;
class PinController;
class ProgressStrip;
class SpectrumPanel;

class SpectrumExport : public QObject {
  Q_OBJECT

 public:
  // All outlive it; dialogs stand before the window.
  SpectrumExport(Document& document, JobRunner& jobs, PinController& pins, ProgressStrip& progress,
                 QWidget* window);

  void attach(SpectrumPanel& panel);

  void copyCurves();
  void copyFigure();
  void copyPins();
  void copyMethods();
  // By a dialog. The extension of the name decides: PDF, SVG, PNG, or CSV for the curves alone.
  void saveFigure();
  void savePins();
  void writeFigure(const QString& path);
  void writePins(const QString& path);

  // Why there are no curves, no pins, and nothing to tell of methods; empty if there are.
  QString objectionToCurves() const;
  QString objectionToPins() const;
  QString objectionToMethods() const;

 Q_SIGNALS:
  void objectionsChanged();

 private:
  // As on paper, with a caption.
  Drawing figure() const;
  void copyText(const std::string& text, const QString& sentence);
  QString choosePlace(const QString& title, const QString& what, const QString& filters);
  void write(const QString& path, std::function<Status()> work);

  Document& document_;
  JobRunner& jobs_;
  PinController& pins_;
  ProgressStrip& progress_;
  QWidget* window_;
  SpectrumPanel* panel_ = nullptr;
};

}  // namespace cutis
