#include "ui/inspector/inspector_panel.h"

#include <QApplication>
#include <QClipboard>
#include <QContextMenuEvent>
#include <QHeaderView>
#include <QKeyEvent>
#include <QMenu>
#include <QPainter>

#include "ui/theme/theme.h"

namespace cutis {

InspectorPanel::InspectorPanel(QWidget* parent) : QTreeWidget(parent) {
  setAccessibleName(tr("Inspector"));
  setColumnCount(3);
  setHeaderHidden(true);
  setRootIsDecorated(false);
  setIndentation(0);
  setUniformRowHeights(true);
  setSelectionMode(QAbstractItemView::NoSelection);
  setFrameShape(QFrame::NoFrame);
  header()->setSectionResizeMode(0, QHeaderView::ResizeToContents);
  header()->setSectionResizeMode(1, QHeaderView::ResizeToContents);
}

void InspectorPanel::showRows(const std::vector<InspectorRow>& rows) {
  sentence_.clear();
  rows_ = rows;
  while (topLevelItemCount() > static_cast<int>(rows.size()))
    delete takeTopLevelItem(topLevelItemCount() - 1);
  while (topLevelItemCount() < static_cast<int>(rows.size()))
    addTopLevelItem(new QTreeWidgetItem);
  for (int i = 0; i < topLevelItemCount(); ++i) {
    const InspectorRow& row = rows[static_cast<std::size_t>(i)];
    QTreeWidgetItem& item = *topLevelItem(i);
    item.setText(0, row.name);
    item.setText(1, row.value);
    item.setText(2, remarkOf(row));
    for (int column = 0; column < columnCount(); ++column) {
      item.setToolTip(column, row.toolTip);
      const bool isDim = column == 0 && !row.isHeading;
      item.setForeground(column, isDim ? theme::tones().dimText : theme::tones().text);
    }
    QFont font = this->font();
    font.setBold(row.isHeading);
    item.setFont(0, font);
    item.setFirstColumnSpanned(row.isHeading);
  }
  viewport()->update();
}

void InspectorPanel::showSentence(const QString& sentence) {
  clear();
  rows_.clear();
  sentence_ = sentence;
  viewport()->update();
}

void InspectorPanel::copy() const {
  if (!rows_.empty()) QApplication::clipboard()->setText(textOf(rows_));
}

void InspectorPanel::keyPressEvent(QKeyEvent* event) {
  if (event->matches(QKeySequence::Copy)) return copy();
  QTreeWidget::keyPressEvent(event);
}

void InspectorPanel::contextMenuEvent(QContextMenuEvent* event) {
  QMenu menu(this);
  menu.addAction(tr("&Copy"), this, &InspectorPanel::copy)->setEnabled(!rows_.empty());
  menu.exec(event->globalPos());
}

void InspectorPanel::paintEvent(QPaintEvent* event) {
  QTreeWidget::paintEvent(event);
  if (sentence_.isEmpty()) return;
  QPainter painter(viewport());
  painter.setPen(theme::tones().dimText);
  painter.drawText(viewport()->rect().adjusted(theme::kSpace, 0, -theme::kSpace, 0),
                   Qt::AlignCenter | Qt::TextWordWrap, sentence_);
}

}  // namespace cutis
