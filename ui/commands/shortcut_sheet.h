#pragma once

// All shortcuts in the groups of the menus. They can be searched, and changed: a double click or
// Enter on a command waits for its new keys. Interface thread only.

#include <QDialog>

#include "ui/commands/shortcut_settings.h"

class QLabel;
class QLineEdit;
class QPushButton;
class QTreeWidget;
class QTreeWidgetItem;

namespace cutis {

class CommandRegistry;

class ShortcutSheet : public QDialog {
  Q_OBJECT

 public:
  // The registry outlives the sheet.
  ShortcutSheet(CommandRegistry& commands, QWidget& window);

  // With all commands.
  void open() override;

 private:
  void layOut();
  void fill();
  void filter(const QString& query);
  QTreeWidgetItem* group(const QString& title);
  void showKeys(QTreeWidgetItem& row) const;
  void startCatching(QTreeWidgetItem* row);
  void stopCatching();
  void take(const QKeySequence& keys);
  void resetCurrent();
  void updateButtons();

  CommandRegistry& commands_;
  ShortcutSettings shortcuts_;
  QLineEdit* query_;
  QTreeWidget* tree_;
  QLabel* message_;
  QPushButton* reset_;
  QPushButton* resetAll_;
  QTreeWidgetItem* catching_ = nullptr;  // whose keys are being waited for
};

}  // namespace cutis
