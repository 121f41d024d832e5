#pragma once  // internal to ui/window

// The submenu of files that were opened before. Interface thread only.

#include <functional>

#include <QMenu>
#include <QStringList>

namespace cutis {

class RecentMenu : public QMenu {
  Q_OBJECT

 public:
  // files: absolute paths that are still there, newest first, asked for each time it is shown.
  explicit RecentMenu(std::function<QStringList()> files, QWidget* parent = nullptr);

 Q_SIGNALS:
  void openWanted(const QString& path);
  void clearWanted();

 private:
  void fillNow();

  std::function<QStringList()> files_;
};

}  // namespace cutis
