#pragma once

// One row of the table of docks: what a dock is called, where it stands at first and what is in it.

#include <functional>

#include <QKeySequence>
#include <QString>

class QWidget;

namespace cutis {

struct DockDescription {
  QString id;  // "spectrum": in saved layouts, never shown
  QString title;
  Qt::DockWidgetArea area = Qt::RightDockWidgetArea;  // docks of one area stand in a column
  QKeySequence shortcut = {};
  bool shownAtFirst = true;
  // Width of a dock at the side, height of one at the foot, in device-independent pixels; the
  // first dock of an area decides.
  int extent = 300;
  // Makes the panel; called once, when the window is made. The dock becomes its owner.
  std::function<QWidget*()> makePanel;
};

}  // namespace cutis
