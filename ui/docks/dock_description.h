#pragma once

// One row of the table of docks: what a dock is called, where it stands at first and what is in it.

#include <functional>

#include <QKeySequence>
#include <QString>

class QWidget;

namespace cutis {

struct DockDescription {
  QString id;     // "spectrum": in saved layouts, never shown
  QString title;  // with the mnemonic of its command: "&Spectrum"
  Qt::DockWidgetArea area = Qt::RightDockWidgetArea;  // docks of one area stand in a column
  QKeySequence shortcut = {};
  bool shownAtFirst = true;
  QString behind = {};  // the id of a dock above in the table whose place it shares, with a tab
  // Width of a dock at the side, height of one at the foot, in device-independent pixels; the
  // first dock of an area decides.
  int extent = 300;
  // Makes the panel; called once, when the window is made. The dock becomes its owner.
  std::function<QWidget*()> makePanel;
  // Told whenever the panel comes into sight or goes out of it, hidden or behind another dock, so
  // that what nobody sees need not be computed. At first it is out of sight.
  std::function<void(QWidget& panel, bool seen)> seen = {};
};

}  // namespace cutis
