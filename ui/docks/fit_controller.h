#pragma once

// Joins the fit panel to the document: a choice fits again, and the panel shows what is in force.
// Interface thread only.

#include <QObject>

#include "src/app/document/document.h"

namespace cutis {

class FitPanel;

class FitController : public QObject {
  Q_OBJECT

 public:
  // Both outlive the controller.
  FitController(Document& document, FitPanel& panel, QObject* parent = nullptr);

  // Ignored where there is nothing to fit.
  void fitWith(const FitChoice& choice);
  void fitWithProfile(const QString& nameOrPath);

 private:
  void showChoice();

  Document& document_;
  FitPanel& panel_;
};

}  // namespace cutis
