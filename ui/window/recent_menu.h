#pragma once  // internal to ui/window

// The submenu of files that were opened before, with small pictures of them. Interface thread only.

#include <functional>

#include <QImage>
#include <QMenu>
#include <QStringList>

namespace cutis {

class RecentMenu : public QMenu {
  Q_OBJECT

 public:
  // files: absolute paths that are still there, newest first, asked for each time it is shown.
  explicit RecentMenu(std::function<QStringList()> files, QWidget* parent = nullptr);

  // The small picture of a file, null if there is none; asked once for each file that is shown.
  void showThumbnails(const std::function<QImage(const QString& path)>& thumbnailOf);

 Q_SIGNALS:
  void openWanted(const QString& path);
  void clearWanted();

 private:
  void fillNow();

  std::function<QStringList()> files_;
};

}  // namespace cutis
