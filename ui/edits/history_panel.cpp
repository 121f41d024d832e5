#include "ui/edits/history_panel.h"

#include <QSignalBlocker>

#include "ui/theme/theme.h"

namespace cutis {

HistoryPanel::HistoryPanel(QWidget* parent) : QListWidget(parent) {
  setAccessibleName(tr("History"));
  setFrameShape(QFrame::NoFrame);
  setViewportMargins(theme::kSpace, 0, theme::kSpace, theme::kHalfSpace);
  QPalette neutral = palette();
  neutral.setColor(QPalette::Base, theme::tones().panel);
  setPalette(neutral);
  setSelectionMode(SingleSelection);
  setUniformItemSizes(true);
  setTextElideMode(Qt::ElideRight);
  setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  connect(this, &QListWidget::currentRowChanged, this, &HistoryPanel::choose);
  // A click on the current row of a list that has lost its step changes no row.
  connect(this, &QListWidget::itemClicked, this, &HistoryPanel::choose);
}

void HistoryPanel::choose() {
  if (currentRow() >= 0 && currentRow() != current_) Q_EMIT stepChosen(currentRow());
}

void HistoryPanel::setSteps(const QStringList& names, int current) {
  const QSignalBlocker silent(this);
  while (count() > names.size())
    delete takeItem(count() - 1);
  while (count() < names.size())
    new QListWidgetItem(this);
  for (int row = 0; row < count(); ++row) {
    QListWidgetItem& step = *item(row);
    const bool isUndone = row > current;
    step.setText(row == current ? tr("%1 — now").arg(names[row]) : names[row]);
    step.setForeground(isUndone ? theme::tones().dimText : theme::tones().text);
    QFont lettering = font();
    lettering.setItalic(isUndone);
    step.setFont(lettering);
    step.setToolTip(isUndone ? tr("Undone; a click brings it back") : tr("A click goes back here"));
  }
  current_ = current;
  setCurrentRow(current);
  scrollToItem(item(current));
}

}  // namespace cutis
