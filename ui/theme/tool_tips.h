#pragma once  // internal to ui/theme

// Tool tips in lines that can be read: Qt breaks only rich text, and shows a longer sentence as one
// line across the screen.
//
// Interface thread only.

#include <QObject>

namespace cutis::theme {

// Watches the whole application: what a widget, an entry of a menu or an item of a list has as its
// tool tip is broken into lines of at most about 80 characters. Rich text and short texts are shown
// as they are.
class ToolTips : public QObject {
  Q_OBJECT

 public:
  explicit ToolTips(QObject* application);

  bool eventFilter(QObject* watched, QEvent* event) override;
};

}  // namespace cutis::theme
