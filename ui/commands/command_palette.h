#pragma once

// Any command by a few letters of its name. It lies over the upper middle of the window, lists what
// matches while one types, says of commands that cannot run why, and runs the chosen one with
// Enter or a click. It goes with Esc, or when something else gets the keyboard. Interface thread
// only.

#include <QFrame>
#include <QPointer>

class QLabel;
class QLineEdit;
class QListWidget;

namespace cutis {

class CommandRegistry;

class CommandPalette : public QFrame {
  Q_OBJECT

 public:
  // Both outlive the palette, whose parent the window becomes.
  CommandPalette(CommandRegistry& commands, QWidget& window);

  // Empty, with all commands, and with the keyboard.
  void open();

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override;

 private:
  void placeInWindow();
  void fill(const QString& query);
  void runCurrent();
  // Gives the keyboard back to what had it.
  void dismiss();
  bool keyPressed(int key);
  void moveBy(int rows);

  CommandRegistry& commands_;
  QWidget& window_;
  QLineEdit* query_;
  QListWidget* list_;
  QLabel* nothing_;
  QPointer<QWidget> before_;  // had the keyboard
};

}  // namespace cutis
