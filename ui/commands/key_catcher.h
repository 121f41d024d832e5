#pragma once  // internal to ui/commands

// Waits for the keys of a shortcut: whatever is pressed is caught and does nothing else.

#include <QKeySequence>
#include <QLineEdit>

namespace cutis {

class KeyCatcher : public QLineEdit {
  Q_OBJECT

 public:
  explicit KeyCatcher(QWidget* parent = nullptr);

 Q_SIGNALS:
  // Empty for Backspace and Delete: none any more.
  void caught(const QKeySequence& keys);
  // By Esc, or because something else has the keyboard now.
  void givenUp();

 protected:
  bool event(QEvent* event) override;
  void keyPressEvent(QKeyEvent* event) override;
  void focusOutEvent(QFocusEvent* event) override;
};

}  // namespace cutis
