#pragma once

// Joins the fit panel to the document: a choice fits again, and the panel shows what is in force.
// Interface thread only.

#include <QObject>

#include "src/app/document/document.h"

class QWidget;

namespace cutis {

class FitPanel;

class FitController : public QObject {
  Q_OBJECT

 public:
  // The document outlives the controller.
  explicit FitController(Document& document, QObject* parent = nullptr);

  // From now on the panel shows what is in force and chooses.
  void attach(FitPanel& panel);

  // Ignored where there is nothing to fit.
  void fitWith(const FitChoice& choice);
  // As chosen, where the last fit was cancelled.
  void fitAgain();
  // Why it cannot be fitted again now, in one sentence; empty if it can.
  QString objection() const;
  void fitWithProfile(const QString& nameOrPath);
  // With a profile from a file, by a dialog before the window.
  void chooseProfile(QWidget& window);

 private:
  void showChoice(FitPanel& panel) const;
  void showExposure(FitPanel& panel) const;

  Document& document_;
};

}  // namespace cutis
