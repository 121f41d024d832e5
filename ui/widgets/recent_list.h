#pragma once

// Recent files, newest first: file name above its folder, beside a small picture where there is
// one. A click or Return opens one.

#include <functional>

#include <QImage>
#include <QListWidget>
#include <QStringList>

namespace cutis {

class RecentList : public QListWidget {
  Q_OBJECT

 public:
  explicit RecentList(QWidget* parent = nullptr);

  // Absolute paths.
  void setFiles(const QStringList& paths);
  // The small picture of a file, null if there is none; asked once for each file of the list.
  void showThumbnails(const std::function<QImage(const QString& path)>& thumbnailOf);

  // The list is as high as its files, up to eight of them.
  QSize sizeHint() const override;
  QSize minimumSizeHint() const override;

 Q_SIGNALS:
  void fileChosen(const QString& path);

 protected:
  void keyPressEvent(QKeyEvent* event) override;
};

}  // namespace cutis
