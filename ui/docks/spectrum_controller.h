#pragma once

// Joins the cursor to the spectrum plot and the read-out: shows the spectra of the pixel under it,
// computed exactly. The plot keeps the last one when the cursor leaves, the read-out does not.
// Interface thread only.

#include <optional>

#include <QObject>
#include <QPoint>

#include "src/app/document/document.h"

namespace cutis {

class ProgressStrip;
class SpectrumPlot;
class Viewport;

class SpectrumController : public QObject {
  Q_OBJECT

 public:
  // All outlive the controller.
  SpectrumController(Document& document, Viewport& viewport, SpectrumPlot& plot,
                     ProgressStrip& progress, QObject* parent = nullptr);

  // Whether anybody sees the plot. While nobody does no spectrum is computed. At first nobody does.
  void setSeen(bool seen);

 private:
  void pointAt(int x, int y);
  void leave();
  void refresh();
  void showReadout(const QPoint& pixel);
  void plotSpectra(int x, int y);
  void forget();

  Document& document_;
  SpectrumPlot& plot_;
  ProgressStrip& progress_;
  bool seen_ = false;
  std::optional<QPoint> pixel_;  // of the spectrum that is shown
  bool isPointedAt_ = false;     // the cursor is still on it
};

}  // namespace cutis
