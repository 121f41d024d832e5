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
    const QRect inside =
        option.rect.adjusted(theme::kSpace, theme::kHalfSpace + 2, -theme::kSpace, 0);
    const int line = option.fontMetrics.height();
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
  }
  updateGeometry();
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
