#include "ui/widgets/recent_list.h"

#include <QDir>
#include <QFileInfo>
#include <QKeyEvent>
#include <QPainter>
#include <QStyledItemDelegate>

#include "ui/theme/theme.h"

namespace cutis {
namespace {

constexpr int kMostVisible = 8;

// Fitted into the square, at the density of the screen. An empty plate where there is none.
void drawThumbnail(QPainter& painter, const QRect& square, const QImage& thumbnail) {
  if (thumbnail.isNull()) {
    painter.fillRect(square, theme::tones().raised);
    return;
  }
  const double density = painter.device()->devicePixelRatioF();
  QImage image =
      thumbnail.scaled(square.size() * density, Qt::KeepAspectRatio, Qt::SmoothTransformation);
  image.setDevicePixelRatio(density);
  const QSizeF size = QSizeF(image.size()) / density;
  painter.drawImage(QPointF(square.left() + (square.width() - size.width()) / 2,
                            square.top() + (square.height() - size.height()) / 2),
                    image);
}

QString shownFolder(const QString& path) {
  const QString folder = QFileInfo(path).path();
  const QString home = QDir::homePath();
  const bool below = folder == home || folder.startsWith(home + '/');
  return QDir::toNativeSeparators(below ? "~" + folder.mid(home.size()) : folder);
}

class FileDelegate : public QStyledItemDelegate {
 public:
  using QStyledItemDelegate::QStyledItemDelegate;

  QSize sizeHint(const QStyleOptionViewItem& option, const QModelIndex&) const override {
    return {120, 2 * option.fontMetrics.height() + theme::kSpace + theme::kHalfSpace};
  }

  void paint(QPainter* painter, const QStyleOptionViewItem& option,
             const QModelIndex& index) const override {
    const theme::Tones& tones = theme::tones();
    const bool lit = option.state & (QStyle::State_MouseOver | QStyle::State_HasFocus);
    painter->save();
    if (lit) painter->fillRect(option.rect, tones.raised);
    QRect inside = option.rect.adjusted(theme::kSpace, theme::kHalfSpace + 2, -theme::kSpace, 0);
    const int line = option.fontMetrics.height();
    const QRect square(inside.topLeft(), QSize(2 * line, 2 * line));
    drawThumbnail(*painter, square, index.data(Qt::DecorationRole).value<QImage>());
    inside.setLeft(square.right() + 1 + theme::kSpace);
    const QString path = index.data(Qt::UserRole).toString();
    const auto draw = [&](int row, const QString& text, const QColor& color, auto elide) {
      painter->setPen(color);
      painter->drawText(QRect(inside.left(), inside.top() + row * line, inside.width(), line),
                        Qt::AlignLeft | Qt::AlignVCenter,
                        option.fontMetrics.elidedText(text, elide, inside.width()));
    };
    draw(0, QFileInfo(path).fileName(), tones.text, Qt::ElideRight);
    draw(1, shownFolder(path), tones.dimText, Qt::ElideMiddle);
    if (option.state & QStyle::State_HasFocus) {
      theme::drawFocusRing(*painter, QRectF(option.rect));
    }
    painter->restore();
  }
};

}  // namespace

RecentList::RecentList(QWidget* parent) : QListWidget(parent) {
  setAccessibleName(tr("Recent files"));
  setFrameShape(NoFrame);
  setItemDelegate(new FileDelegate(this));
  setMouseTracking(true);
  setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Preferred);
  QPalette neutral = palette();
  neutral.setColor(QPalette::Base, theme::tones().panel);
  setPalette(neutral);
  connect(this, &QListWidget::itemClicked, this, [this](QListWidgetItem* item) {
    Q_EMIT fileChosen(item->data(Qt::UserRole).toString());
  });
}

void RecentList::setFiles(const QStringList& paths) {
  QListWidget::clear();
  for (const QString& path : paths) {
    auto* item = new QListWidgetItem(QFileInfo(path).fileName(), this);
    item->setData(Qt::UserRole, path);
    item->setToolTip(QDir::toNativeSeparators(path));
    item->setData(Qt::AccessibleTextRole,
                  tr("%1 in %2").arg(QFileInfo(path).fileName(), shownFolder(path)));
  }
  updateGeometry();
}

void RecentList::showThumbnails(const std::function<QImage(const QString& path)>& thumbnailOf) {
  for (int row = 0; row < count(); ++row)
    item(row)->setData(Qt::DecorationRole, thumbnailOf(item(row)->data(Qt::UserRole).toString()));
}

// itemActivated would open twice at a double click.
void RecentList::keyPressEvent(QKeyEvent* event) {
  const bool opens = event->key() == Qt::Key_Return || event->key() == Qt::Key_Enter;
  if (!opens || !currentItem()) return QListWidget::keyPressEvent(event);
  Q_EMIT fileChosen(currentItem()->data(Qt::UserRole).toString());
}

QSize RecentList::sizeHint() const {
  const int row = count() > 0 ? sizeHintForRow(0) : 0;
  return {240, row * std::min(count(), kMostVisible)};
}

QSize RecentList::minimumSizeHint() const {
  return {160, count() > 0 ? std::min(sizeHint().height(), 3 * sizeHintForRow(0)) : 0};
}

}  // namespace cutis
