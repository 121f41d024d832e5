#pragma once

// The pins of a document: a click in the picture sets one; its marker can be dragged; its curve
// follows the maps and the edits. What pins show is computed in the background, and only while
// somebody sees it. Interface thread only.

#include <optional>
#include <string>
#include <vector>

#include <QObject>
#include <QString>

#include "src/app/document/document.h"
#include "src/app/document/pin_readings.h"
#include "src/app/latest_job.h"

class QWidget;

namespace cutis {

class ProgressStrip;
class SpectrumPanel;
class Viewport;

class PinController : public QObject {
  Q_OBJECT

 public:
  // All outlive the controller; dialogs stand before the window.
  PinController(Document& document, JobRunner& jobs, Viewport& viewport, ProgressStrip& progress,
                QWidget* window);

  void attach(SpectrumPanel& panel);
  // Whether anybody sees curves and numbers of pins. At first nobody does.
  void setSeen(bool seen);

  // As last computed, for the pins of then.
  const std::vector<PinReading>& readings() const { return readings_; }
  // Why these are not those of now, in one sentence; empty if they are.
  QString objectionToReadings() const;

  void add(int x, int y);
  void select(const std::string& letter);
  void setName(const std::string& letter, const QString& name);
  void setSize(int size);
  // Of the selected pin, by a dialog. Precondition, here and below: no objection.
  void rename();
  void removeSelected();
  // Makes it the pin that colours are compared with; or not, where it is already.
  void toggleReference();
  void removeAll();
  // Whether colours are compared with the selected pin.
  bool isReference() const;
  // Why not, in one sentence; empty if they can.
  QString objectionToOne() const;
  QString objectionToAll() const;

 Q_SIGNALS:
  void readingsChanged();
  void selectionChanged();

 private:
  void move(int marker, int x, int y);
  void pinsChanged();
  void showMarkers();
  void compute();
  void take(const std::vector<PinReading>& readings, const std::optional<Band>& measured);

  Document& document_;
  Viewport& viewport_;
  ProgressStrip& progress_;
  QWidget* window_;
  SpectrumPanel* panel_ = nullptr;
  LatestJob job_;
  bool seen_ = false;
  std::string selected_;  // the letter of the pin that commands work on; empty: none
  std::vector<PinReading> readings_;
};

}  // namespace cutis
