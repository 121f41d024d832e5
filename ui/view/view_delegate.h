#pragma once  // internal to ui/view

// Draws one view of the strip: thumbnail above name. Until a thumbnail has come, a neutral plate
// with a fold of lines stands in, which cannot be taken for a picture.

#include <QStyledItemDelegate>

namespace cutis {

class ViewDelegate : public QStyledItemDelegate {
 public:
  // Roles beside Qt::DisplayRole, the name.
  static constexpr int kIdRole = Qt::UserRole;
  static constexpr int kThumbnailRole = Qt::UserRole + 1;  // QImage

  // The size of a thumbnail in device-independent pixels.
  static constexpr QSize kThumbnailSize = {108, 72};

  using QStyledItemDelegate::QStyledItemDelegate;

  void paint(QPainter* painter, const QStyleOptionViewItem& option,
             const QModelIndex& index) const override;
  QSize sizeHint(const QStyleOptionViewItem& option, const QModelIndex& index) const override;
};

}  // namespace cutis
