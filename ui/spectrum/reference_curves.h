#pragma once

// Spectra from files that are drawn beside those of the picture, each with a name. They stay while
// documents of the page come and go, and are no part of a project. Files are read in the
// background. Interface thread only.

#include <vector>

#include <QObject>
#include <QString>

#include "src/app/job_runner.h"
#include "ui/plot/spectrum_figure.h"

class QWidget;

namespace cutis {

class ProgressStrip;
class SpectrumPanel;

// More are no figure.
inline constexpr std::size_t kMostReferences = 8;

class ReferenceCurves : public QObject {
  Q_OBJECT

 public:
  // All outlive it; dialogs stand before the window.
  ReferenceCurves(JobRunner& jobs, ProgressStrip& progress, QWidget* window);

  void attach(SpectrumPanel& panel) { panel_ = &panel; }

  // By a dialog.
  void choose();
  // Whatever src/files/spectra/measured_spectra_file.h reads.
  void add(const QString& path);
  void removeAll();
  // Why there is nothing to remove, in one sentence; empty if there is.
  QString objectionToRemoving() const;

 private:
  void take(const QString& file, const std::vector<NamedCurve>& curves, const QString& notes);

  JobRunner& jobs_;
  ProgressStrip& progress_;
  QWidget* window_;
  SpectrumPanel* panel_ = nullptr;
  std::vector<NamedCurve> curves_;
};

}  // namespace cutis
