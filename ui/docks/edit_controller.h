#pragma once

// Joins the edit panel to the document: factors become commands, and undo moves the sliders back.
// Interface thread only.

#include <QObject>

#include "src/app/document/document.h"

namespace cutis {

class EditPanel;

class EditController : public QObject {
  Q_OBJECT

 public:
  // Both outlive the controller.
  EditController(Document& document, EditPanel& panel, QObject* parent = nullptr);

  void setFactor(int parameter, double factor, bool stillMoving);
  void reset();

 private:
  void showFactors();

  Document& document_;
  EditPanel& panel_;
  bool applying_ = false;  // the change comes from the panel, which shows it already
};

}  // namespace cutis
