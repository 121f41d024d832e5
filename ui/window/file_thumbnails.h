#pragma once  // internal to ui/window

// Small pictures of recent files, kept in a folder between sessions.
//
// They show faces: only their owner may read them, and they are no more than the recent files. Each
// is named by its file's path and time of change, so that a file that has changed, or has gone, has
// none. Scaling, reading and writing happen in the background. Interface thread only.

#include <filesystem>

#include <QHash>
#include <QImage>
#include <QObject>
#include <QStringList>

namespace cutis {

class JobRunner;

class FileThumbnails : public QObject {
  Q_OBJECT

 public:
  // The longer side, in pixels: what a list shows on a screen of twice the usual density.
  static constexpr int kSide = 96;

  // `jobs` outlives it. An empty folder: nothing is kept.
  FileThumbnails(JobRunner& jobs, std::filesystem::path folder, QObject* parent = nullptr);

  // Keeps the picture of a file, and besides it only those of `recent`. Paths are absolute.
  void keep(const QString& file, const QImage& picture, const QStringList& recent);
  // Looks for what was kept of these; changed() follows.
  void look(const QStringList& files);
  // Null: there is none, or it was not found yet.
  QImage of(const QString& file) const { return found_.value(file); }
  // Removes them all.
  void clear();

 Q_SIGNALS:
  void changed();

 private:
  JobRunner& jobs_;
  std::filesystem::path folder_;
  QHash<QString, QImage> found_;
};

// Where they are kept; empty if there is no place.
std::filesystem::path thumbnailFolder();

}  // namespace cutis
