#include "ui/window/recent_menu.h"

#include <utility>

#include <QFileInfo>
#include <QIcon>
#include <QPixmap>

namespace cutis {

RecentMenu::RecentMenu(std::function<QStringList()> files, QWidget* parent)
    : QMenu(tr("Open &recent"), parent), files_(std::move(files)) {
  setToolTipsVisible(true);
  connect(this, &QMenu::aboutToShow, this, &RecentMenu::fillNow);
}

void RecentMenu::fillNow() {
  clear();
  const QStringList files = files_();
  int number = 1;
  for (const QString& file : files) {
    const QFileInfo info(file);
    // A single & would be taken as a mnemonic.
    const QString name = info.fileName().replace("&", "&&");
    QAction* row =
        addAction(tr("&%1  %2").arg(number++).arg(name), [this, file] { Q_EMIT openWanted(file); });
    row->setToolTip(file);
    row->setData(file);
    row->setIconVisibleInMenu(true);
  }
  if (files.isEmpty()) addAction(tr("Nothing was opened yet"))->setEnabled(false);
  addSeparator();
  addAction(tr("&Clear recent files"), this, &RecentMenu::clearWanted)
      ->setEnabled(!files.isEmpty());
}

void RecentMenu::showThumbnails(const std::function<QImage(const QString& path)>& thumbnailOf) {
  for (QAction* row : actions()) {
    const QString file = row->data().toString();
    const QImage thumbnail = file.isEmpty() ? QImage() : thumbnailOf(file);
    row->setIcon(thumbnail.isNull() ? QIcon() : QIcon(QPixmap::fromImage(thumbnail)));
  }
}

}  // namespace cutis
