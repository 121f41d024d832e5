#pragma once  // internal to ui/commands

// Draws a command in the palette: its name, where it stands and why it cannot run, and on the right
// its shortcut.

#include <QStyledItemDelegate>

namespace cutis {

class CommandDelegate : public QStyledItemDelegate {
  Q_OBJECT

 public:
  // Beside the name, which is the text of the item; a reason is there only for what cannot run.
  enum Role { idRole = Qt::UserRole, placeRole, reasonRole, shortcutRole };

  using QStyledItemDelegate::QStyledItemDelegate;

  QSize sizeHint(const QStyleOptionViewItem& option, const QModelIndex& index) const override;
  void paint(QPainter* painter, const QStyleOptionViewItem& option,
             const QModelIndex& index) const override;
};

}  // namespace cutis
