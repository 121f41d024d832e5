#pragma once

// Joins the cursor to the spectrum plot and the read-out: shows the spectra of the pixel under it,
// computed exactly and in the background, or
// the mean of those about it. The plot keeps the last one when the cursor leaves, the read-out does
// not. Interface thread only.

#include <optional>
#include <vector>

#include <QObject>
#include <QPoint>

#include "src/app/document/document.h"
#include "src/app/latest_job.h"
#include "ui/plot/spectrum_figure.h"

namespace cutis {

class ProgressStrip;
class SpectrumPanel;
class Viewport;

class SpectrumController : public QObject {
  Q_OBJECT

 public:
  // All outlive the controller.
  SpectrumController(Document& document, JobRunner& jobs, Viewport& viewport,
                     ProgressStrip& progress);

  // The panel shows what is known; without one nothing is computed.
  void attach(SpectrumPanel& panel);
  // Whether anybody sees the plot. While nobody does no spectrum is computed. At first nobody does.
  void setSeen(bool seen);

 private:
  // What is known of a place, on its way to the plot.
  struct Shown {
    QPoint pixel;
    int size = 1;
    std::optional<Band> measured;
    std::optional<PlaceSpectra> place;
    std::vector<NamedCurve> parts = {};
  };

  void pointAt(int x, int y);
  void leave();
  void refresh();
  void showReadout(const QPoint& pixel, const std::optional<ParameterVector>& deviation);
  void plotSpectra(const QPoint& pixel);
  void setQuantity(SpectrumQuantity quantity);
  void show(const Shown& shown);
  void forget();

  Document& document_;
  SpectrumPanel* panel_ = nullptr;
  ProgressStrip& progress_;
  LatestJob job_;
  SpectrumQuantity quantity_ = SpectrumQuantity::reflectance;
  bool seen_ = false;
  std::optional<QPoint> pixel_;  // of the spectrum that is shown
  bool isPointedAt_ = false;     // the cursor is still on it
};

}  // namespace cutis
