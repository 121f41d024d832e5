#include "src/app/project/journal.h"

#include <functional>
#include <set>
#include <utility>

#include <QUuid>

#include "src/app/project/manifest.h"
#include "src/files/io/atomic_write.h"
#include "src/files/system/platform.h"

namespace cutis {

namespace fs = std::filesystem;

namespace {

constexpr char kLockEnding[] = ".lock";

// Every file in the folder; none where there is no folder.
std::vector<fs::path> filesIn(const fs::path& folder) {
  std::vector<fs::path> files;
  std::error_code error;
  for (auto at = fs::directory_iterator(folder, error); !error && at != fs::directory_iterator();
       at.increment(error)) {
    files.push_back(at->path());
  }
  return files;
}

// What stands before the last hyphen or the dot: "INSTANCE-3.cutis", "INSTANCE.lock", and of what
// is still being written ".INSTANCE-3-PROCESS-0.partial.cutis".
QString instanceOf(const fs::path& file) {
  const std::string name = file.filename().string();
  const std::size_t begin = name.starts_with('.') ? 1 : 0;
  return QString::fromStdString(name.substr(begin, name.find_first_of("-.", begin) - begin));
}

std::set<QString> instancesIn(const fs::path& folder) {
  std::set<QString> instances;
  for (const fs::path& file : filesIn(folder))
    instances.insert(instanceOf(file));
  return instances;
}

// Locks in the name of an instance that has ended; fails while it runs.
bool lockFor(QLockFile& lock) {
  lock.setStaleLockTime(0);
  return lock.tryLock(0);
}

// Each journal that no running instance holds.
void visitAbandoned(const fs::path& folder, const std::function<void(const fs::path&)>& visit) {
  for (const QString& instance : instancesIn(folder)) {
    QLockFile lock(
        QString::fromStdString((folder / (instance.toStdString() + kLockEnding)).string()));
    if (!lockFor(lock)) continue;
    for (const fs::path& file : filesIn(folder)) {
      if (instanceOf(file) == instance && file.extension() != kLockEnding) visit(file);
    }
  }
}

}  // namespace

fs::path journalFolder() {
  const fs::path folder = stateFolder();
  return folder.empty() ? folder : folder / "journals";
}

std::uint64_t Journal::nextTurn() {
  const std::scoped_lock lock(mutex_);
  return ++issued_;
}

Status Journal::write(std::uint64_t turn, const std::string& text) {
  const std::scoped_lock lock(mutex_);
  if (turn <= written_) return {};
  written_ = turn;
  // A file that is there keeps its mode.
  std::error_code ignored;
  if (!fs::exists(path_, ignored) && !createPrivateFile(path_)) {
    return resourceError(path_.string(),
                         "unsaved edits cannot be written there and a crash would lose them; save "
                         "the project, or make the folder writable");
  }
  return writeTextAtomically(path_, text);
}

void Journal::erase() {
  const std::scoped_lock lock(mutex_);
  written_ = ++issued_;
  std::error_code ignored;
  fs::remove(path_, ignored);
}

JournalFolder::JournalFolder(fs::path folder, const QString& instance)
    : folder_(std::move(folder)),
      instance_(instance),
      lock_(QString::fromStdString(pathOf(instance, kLockEnding).string())) {}

Result<std::unique_ptr<JournalFolder>> JournalFolder::open(const fs::path& folder) {
  std::error_code error;
  fs::create_directories(folder, error);
  if (!error) fs::permissions(folder, fs::perms::owner_all, error);
  std::unique_ptr<JournalFolder> opened(
      new JournalFolder(folder, QUuid::createUuid().toString(QUuid::Id128)));
  if (error || !lockFor(opened->lock_)) {
    return resourceError(folder.string(),
                         "unsaved edits cannot be written there and a crash would lose them; make "
                         "the folder writable");
  }
  return opened;
}

fs::path JournalFolder::pathOf(const QString& instance, const std::string& ending) const {
  return folder_ / (instance.toStdString() + ending);
}

std::shared_ptr<Journal> JournalFolder::add() {
  return std::make_shared<Journal>(
      pathOf(instance_, "-" + std::to_string(count_++) + kProjectExtension));
}

std::vector<std::shared_ptr<Journal>> JournalFolder::takeAbandoned() {
  std::vector<std::shared_ptr<Journal>> taken;
  for (const QString& instance : instancesIn(folder_)) {
    if (instance == instance_) continue;
    QLockFile lock(QString::fromStdString(pathOf(instance, kLockEnding).string()));
    if (lockFor(lock)) take(instance, taken);
  }
  return taken;
}

void JournalFolder::take(const QString& instance, std::vector<std::shared_ptr<Journal>>& taken) {
  std::error_code error;
  for (const fs::path& file : filesIn(folder_)) {
    if (instanceOf(file) != instance || file.extension() == kLockEnding) continue;
    const bool isPartial = file.filename().string().starts_with('.');
    if (isPartial || fs::is_empty(file, error)) {
      fs::remove(file, error);
      continue;
    }
    auto journal = add();
    fs::rename(file, journal->path(), error);
    if (!error) taken.push_back(std::move(journal));
  }
}

int removeAbandonedJournals(const fs::path& folder) {
  int removed = 0;
  std::error_code error;
  visitAbandoned(folder, [&](const fs::path& file) { removed += fs::remove(file, error) ? 1 : 0; });
  return removed;
}

int countAbandonedJournals(const fs::path& folder) {
  int count = 0;
  std::error_code error;
  visitAbandoned(folder, [&](const fs::path& file) {
    const bool isPartial = file.filename().string().starts_with('.');
    count += !isPartial && !fs::is_empty(file, error) ? 1 : 0;
  });
  return count;
}

}  // namespace cutis
