#pragma once

// Joins the edit panel to the document: factors become commands, and undo moves the sliders back.
// Interface thread only.

#include <array>

#include <QObject>

#include "src/app/document/document.h"

namespace cutis {

class EditPanel;
class ViewController;

class EditController : public QObject {
  Q_OBJECT

 public:
  // Both outlive the controller.
  EditController(Document& document, ViewController& views, QObject* parent = nullptr);

  // From now on the panel shows the factors and sets them.
  void attach(EditPanel& panel);

  // While the photograph is shown the edited albedo takes its place: an edit must be seen. Ignored
  // while nothing is open. Where the control does not move any more this is a whole step of undo.
  void setFactor(int parameter, double factor, bool stillMoving);
  void reset();

 Q_SIGNALS:
  // Indexed by Parameter.
  void factorsChanged(const std::array<double, cutis::kParameterCount>& factors);
  // Whether there are edits that factors do not show.
  void furtherEditsChanged(bool any);

 private:
  void change(int parameter, double factor, bool stillMoving);
  void showFactors();
  // Why nothing can be edited; empty if it can.
  QString objection() const;

  Document& document_;
  ViewController& views_;
  bool applying_ = false;  // the change comes from the panel, which shows it already
};

// Whether the sliders of the edit panel show all of it: one factor for each parameter within their
// scale, in one edit of the whole picture.
bool slidersShow(const EditStack& edits);

}  // namespace cutis
