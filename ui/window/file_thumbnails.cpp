#include "ui/window/file_thumbnails.h"

#include <algorithm>
#include <string>
#include <system_error>
#include <utility>

#include <QFile>
#include <QImageReader>
#include <QImageWriter>
#include <QSet>

#include "core/base/content_hash.h"
#include "src/app/job_runner.h"
#include "src/files/system/platform.h"

namespace cutis {
namespace {

namespace fs = std::filesystem;

constexpr char kFormat[] = "png";

// The name that suits a file as it is now; empty if it has gone.
std::string nameFor(const QString& file) {
  std::error_code error;
  const fs::path path = file.toStdString();
  const auto changed = fs::last_write_time(path, error);
  if (error) return {};
  ContentHash hash;
  hash.add(std::string_view(path.native()));
  hash.add(std::string_view(std::to_string(changed.time_since_epoch().count())));
  return hash.digest() + "." + kFormat;
}

QString textOf(const fs::path& path) {
  return QString::fromStdString(path.string());
}

QImage readThumbnail(const fs::path& path) {
  QImageReader reader(textOf(path), kFormat);
  const QSize size = reader.size();
  const int longer = std::max(size.width(), size.height());
  return longer > FileThumbnails::kSide ? QImage() : reader.read();
}

// Nothing is said where it cannot be kept: it is made again the next time.
void writeThumbnail(const fs::path& path, const QImage& image) {
  std::error_code ignored;
  fs::create_directories(path.parent_path(), ignored);
  fs::permissions(path.parent_path(), fs::perms::owner_all, ignored);
  const fs::path temporary = path.string() + "." + std::to_string(processId());
  if (!createPrivateFile(temporary)) return;
  QImageWriter writer(textOf(temporary), kFormat);
  const bool isWritten = writer.write(image);
  if (isWritten) fs::rename(temporary, path, ignored);
  if (!isWritten || ignored) fs::remove(temporary, ignored);
}

void removeOthers(const fs::path& folder, const QStringList& files) {
  QSet<QString> names;
  for (const QString& file : files)
    names.insert(QString::fromStdString(nameFor(file)));
  std::error_code ignored;
  for (const fs::directory_entry& entry : fs::directory_iterator(folder, ignored)) {
    if (!names.contains(textOf(entry.path().filename()))) fs::remove(entry.path(), ignored);
  }
}

}  // namespace

FileThumbnails::FileThumbnails(JobRunner& jobs, fs::path folder, QObject* parent)
    : QObject(parent), jobs_(jobs), folder_(std::move(folder)) {}

void FileThumbnails::keep(const QString& file, const QImage& picture, const QStringList& recent) {
  if (folder_.empty() || picture.isNull()) return;
  jobs_.startQuiet([this, folder = folder_, file, picture, recent](const JobRunner::Handle& job) {
    const QImage small =
        picture.scaled(kSide, kSide, Qt::KeepAspectRatio, Qt::SmoothTransformation);
    const std::string name = nameFor(file);
    if (name.empty() || job.context.stopRequested()) return;
    writeThumbnail(folder / name, small);
    removeOthers(folder, recent + QStringList(file));
    job.post([this, file, small] {
      found_[file] = small;
      Q_EMIT changed();
    });
  });
}

void FileThumbnails::look(const QStringList& files) {
  if (folder_.empty() || files.isEmpty()) return;
  jobs_.startQuiet([this, folder = folder_, files](const JobRunner::Handle& job) {
    QHash<QString, QImage> found;
    for (const QString& file : files) {
      const std::string name = nameFor(file);
      const QImage image = name.empty() ? QImage() : readThumbnail(folder / name);
      if (!image.isNull()) found[file] = image;
    }
    job.post([this, found] {
      if (found == found_) return;
      found_ = found;
      Q_EMIT changed();
    });
  });
}

void FileThumbnails::clear() {
  found_.clear();
  std::error_code ignored;
  if (!folder_.empty()) fs::remove_all(folder_, ignored);
  Q_EMIT changed();
}

std::filesystem::path thumbnailFolder() {
  const fs::path cache = cacheFolder();
  return cache.empty() ? fs::path() : cache / "thumbnails";
}

}  // namespace cutis
