#pragma once

// Joins the list of steps to the document's history. Interface thread only.

#include <QObject>

#include "src/app/document/document.h"

namespace cutis {

class HistoryPanel;

class HistoryController : public QObject {
  Q_OBJECT

 public:
  // Both outlive the controller.
  HistoryController(Document& document, HistoryPanel& panel, QObject* parent = nullptr);

 private:
  void showSteps();

  Document& document_;
  HistoryPanel& panel_;
};

}  // namespace cutis
