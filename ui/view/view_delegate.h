#pragma once  // internal to ui/view

// Draws one view of the strip: thumbnail beside name, or the heading of a group. Until a thumbnail
// has come, a neutral plate with a fold of lines stands in, which cannot be taken for a picture.

#include <QStyledItemDelegate>

namespace cutis {

class ViewDelegate : public QStyledItemDelegate {
 public:
  // Roles beside Qt::DisplayRole, the name.
  static constexpr int kIdRole = Qt::UserRole;
  static constexpr int kThumbnailRole = Qt::UserRole + 1;  // QImage
  static constexpr int kHeadingRole = Qt::UserRole + 2;    // true: no view

  // The size of a thumbnail in device-independent pixels.
  static constexpr QSize kThumbnailSize = {48, 32};

  using QStyledItemDelegate::QStyledItemDelegate;

  void paint(QPainter* painter, const QStyleOptionViewItem& option,
             const QModelIndex& index) const override;
  QSize sizeHint(const QStyleOptionViewItem& option, const QModelIndex& index) const override;
};

}  // namespace cutis
