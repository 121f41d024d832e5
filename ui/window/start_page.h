#pragma once  // internal to ui/window

// What stands in the window while nothing is open: the sample, the ways to open something, recent
// files, and what went wrong with one. Interface thread only.

#include <functional>

#include <QImage>
#include <QStringList>
#include <QWidget>

class QLabel;
class QPushButton;

namespace cutis {

class RecentList;

class StartPage : public QWidget {
  Q_OBJECT

 public:
  explicit StartPage(QWidget* parent = nullptr);

  // Absolute paths, newest first; without any the section is not shown.
  void setRecentFiles(const QStringList& paths);
  // As RecentList::showThumbnails().
  void showThumbnails(const std::function<QImage(const QString& path)>& thumbnailOf);
  // Below the place where files are dropped; an empty text takes it away.
  void showMessage(const QString& text, bool isError);
  // Files are held over the window, which is where they are dropped.
  void setDropLit(bool lit);

 Q_SIGNALS:
  void sampleWanted();
  void captureWanted();  // "Open capture…"
  void imageWanted();    // "Open image, maps or project…"
  // A recent file was chosen.
  void fileWanted(const QString& path);

 protected:
  void paintEvent(QPaintEvent* event) override;

 private:
  QPushButton* sample_;
  QWidget* dropArea_;
  QLabel* message_;
  QLabel* recentHeading_;
  RecentList* recent_;
  bool dropLit_ = false;
};

}  // namespace cutis
