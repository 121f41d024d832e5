#include "ui/view/view_strip.h"

#include <QHash>
#include <QImage>
#include <QMouseEvent>
#include <QSignalBlocker>

#include "ui/theme/theme.h"
#include "ui/view/view_delegate.h"

namespace cutis {
namespace {

constexpr int kWidth = 152;
// Thumbnails keep enough pixels for a display at 2 ×.
constexpr int kLargestRatio = 2;

}  // namespace

ViewStrip::ViewStrip(QWidget* parent) : QListWidget(parent) {
  setAccessibleName(tr("Views"));
  setFixedWidth(kWidth);
  setFrameShape(QFrame::NoFrame);
  setItemDelegate(new ViewDelegate(this));
  setSelectionMode(SingleSelection);
  setVerticalScrollMode(ScrollPerPixel);
  setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  setMouseTracking(true);
  setSpacing(1);
  setViewportMargins(2, theme::kHalfSpace, 0, 0);
  // Darker than the plates would hide them.
  QPalette neutral = palette();
  neutral.setColor(QPalette::Base, theme::tones().panel);
  setPalette(neutral);
  connect(this, &QListWidget::currentItemChanged, this, [this](QListWidgetItem* item) {
    if (item) Q_EMIT chosen(item->data(ViewDelegate::kIdRole).toString());
  });
}

void ViewStrip::setViews(const QVector<ViewEntry>& views) {
  const QSignalBlocker silent(this);
  const QString kept = current();
  QHash<QString, QVariant> thumbnails;
  for (int row = 0; row < count(); ++row) {
    thumbnails[item(row)->data(ViewDelegate::kIdRole).toString()] =
        item(row)->data(ViewDelegate::kThumbnailRole);
  }
  QListWidget::clear();
  QString group;
  for (const ViewEntry& view : views) {
    if (view.group != group) addHeading(view.group);
    group = view.group;
    auto* added = new QListWidgetItem(view.name, this);
    added->setToolTip(view.toolTip);
    added->setData(ViewDelegate::kIdRole, view.id);
    added->setData(ViewDelegate::kThumbnailRole, thumbnails.value(view.id));
  }
  QListWidgetItem* found = itemOf(kept);
  setCurrentItem(found ? found : views.isEmpty() ? nullptr : itemOf(views.front().id));
}

void ViewStrip::addHeading(const QString& group) {
  auto* heading = new QListWidgetItem(group, this);
  heading->setFlags(Qt::NoItemFlags);
  heading->setData(ViewDelegate::kHeadingRole, true);
}

void ViewStrip::setThumbnail(const QString& id, const QImage& image) {
  QListWidgetItem* found = itemOf(id);
  if (!found) return;
  const QSize most = ViewDelegate::kThumbnailSize * kLargestRatio;
  const bool large = image.width() > most.width() || image.height() > most.height();
  const QImage kept =
      large ? image.scaled(most, Qt::KeepAspectRatio, Qt::SmoothTransformation) : image;
  found->setData(ViewDelegate::kThumbnailRole, kept);
}

void ViewStrip::setCurrent(const QString& id) {
  const QSignalBlocker silent(this);
  if (QListWidgetItem* found = itemOf(id)) setCurrentItem(found);
}

QString ViewStrip::current() const {
  const QListWidgetItem* item = currentItem();
  return item ? item->data(ViewDelegate::kIdRole).toString() : QString();
}

// The right button asks for a menu and chooses nothing.
void ViewStrip::mousePressEvent(QMouseEvent* event) {
  if (event->button() == Qt::LeftButton) QListWidget::mousePressEvent(event);
}

QListWidgetItem* ViewStrip::itemOf(const QString& id) const {
  for (int row = 0; row < count(); ++row) {
    // A heading has no id.
    const QVariant own = item(row)->data(ViewDelegate::kIdRole);
    if (own.isValid() && own.toString() == id) return item(row);
  }
  return nullptr;
}

}  // namespace cutis
