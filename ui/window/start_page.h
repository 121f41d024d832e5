#pragma once  // internal to ui/window

// What stands in the window while nothing is open: the sample, the ways to open something, recent
// files. Anything dropped anywhere on it is opened. Interface thread only.

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

 Q_SIGNALS:
  void sampleWanted();
  void captureWanted();  // "Open capture…"
  void imageWanted();    // "Open image…"
  // A recent file was chosen or one thing was dropped: a file or a folder.
  void fileWanted(const QString& path);
  // Several were dropped at once: photographs of one capture, or tiles of one set.
  void filesWanted(const QStringList& paths);

 protected:
  void paintEvent(QPaintEvent* event) override;
  void dragEnterEvent(QDragEnterEvent* event) override;
  void dragLeaveEvent(QDragLeaveEvent* event) override;
  void dropEvent(QDropEvent* event) override;

 private:
  void setDropLit(bool lit);

  QPushButton* sample_;
  QWidget* dropArea_;
  QLabel* recentHeading_;
  RecentList* recent_;
  bool dropLit_ = false;
};

}  // namespace cutis
