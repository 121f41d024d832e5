#include "ui/docks/info_panel.h"

#include <QClipboard>
#include <QContextMenuEvent>
#include <QGuiApplication>
#include <QKeyEvent>
#include <QMenu>
#include <QPainter>

#include "ui/theme/theme.h"
#include "ui/widgets/message_mark.h"

namespace cutis {

InfoPanel::InfoPanel(QWidget* parent) : QListWidget(parent) {
  setAccessibleName(tr("Information"));
  setFrameShape(QFrame::NoFrame);
  setViewportMargins(theme::kSpace, 0, theme::kSpace, theme::kHalfSpace);
  QPalette neutral = palette();
  neutral.setColor(QPalette::Base, theme::tones().panel);
  setPalette(neutral);
  setSelectionMode(ExtendedSelection);
  setWordWrap(true);
  setTextElideMode(Qt::ElideNone);
  setResizeMode(Adjust);
  setVerticalScrollMode(ScrollPerPixel);
  setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
}

void InfoPanel::add(const QString& sentence, bool isError) {
  for (int row = count() - 1; row >= 0; --row) {
    if (item(row)->text() == sentence) delete takeItem(row);
  }
  auto* notice = new QListWidgetItem(messageMark(isError), sentence);
  notice->setData(Qt::AccessibleDescriptionRole, isError ? tr("Error") : tr("Notice"));
  insertItem(0, notice);
  viewport()->update();
}

void InfoPanel::keepNewest(int kept) {
  while (count() > kept)
    delete takeItem(count() - 1);
  viewport()->update();
}

void InfoPanel::copy() const {
  QStringList sentences;
  for (int row = 0; row < count(); ++row) {
    if (selectedItems().isEmpty() || item(row)->isSelected()) sentences << item(row)->text();
  }
  QGuiApplication::clipboard()->setText(sentences.join('\n'));
}

void InfoPanel::keyPressEvent(QKeyEvent* event) {
  if (event->matches(QKeySequence::Copy)) return copy();
  QListWidget::keyPressEvent(event);
}

void InfoPanel::contextMenuEvent(QContextMenuEvent* event) {
  auto* menu = new QMenu(this);
  menu->setAttribute(Qt::WA_DeleteOnClose);
  QAction* some = menu->addAction(tr("&Copy"));
  some->setEnabled(!selectedItems().isEmpty());
  QAction* all = menu->addAction(tr("Copy &all"));
  all->setEnabled(count() > 0);
  connect(some, &QAction::triggered, this, &InfoPanel::copy);
  connect(all, &QAction::triggered, this, [this] {
    clearSelection();
    copy();
  });
  menu->popup(event->globalPos());
}

void InfoPanel::paintEvent(QPaintEvent* event) {
  QListWidget::paintEvent(event);
  if (count() > 0) return;
  QPainter painter(viewport());
  painter.setPen(theme::tones().dimText);
  painter.drawText(viewport()->rect().adjusted(theme::kDoubleSpace, theme::kSpace,
                                               -theme::kDoubleSpace, -theme::kSpace),
                   Qt::AlignLeft | Qt::AlignTop | Qt::TextWordWrap,
                   tr("Nothing was assumed, left out or clipped."));
}

}  // namespace cutis
