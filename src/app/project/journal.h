#pragma once

// Journals: unsaved edits, written down while one works, so that a crash costs little.
//
// A journal is the manifest of a project (src/app/project/manifest.h) without maps and with
// absolute paths. Journals of all instances lie in one folder, each instance's under a lock: a
// journal whose lock nobody holds is what a crash left. Only their owner can read them.

#include <cstdint>
#include <filesystem>
#include <memory>
#include <mutex>
#include <string>
#include <vector>

#include <QLockFile>
#include <QString>

#include "core/base/result.h"

namespace cutis {

// Where the journals of this user lie; empty if the system names no place.
std::filesystem::path journalFolder();

// The journal of one document. Thread-safe.
class Journal {
 public:
  explicit Journal(std::filesystem::path path) : path_(std::move(path)) {}

  // A place in the order of the states: of several writes the one with the last place holds.
  std::uint64_t nextTurn();
  Status write(std::uint64_t turn, const std::string& text);
  // Everything is saved, or given up. What is still on its way to be written is dropped.
  void erase();

  const std::filesystem::path& path() const { return path_; }

 private:
  std::filesystem::path path_;
  std::mutex mutex_;
  std::uint64_t issued_ = 0;
  std::uint64_t written_ = 0;
};

// The journals of one running instance. Interface thread only.
class JournalFolder {
 public:
  // Makes the folder where it is not there, and locks. Fails with a sentence where nothing can be
  // written there.
  static Result<std::unique_ptr<JournalFolder>> open(const std::filesystem::path& folder);

  std::shared_ptr<Journal> add();

  // The journals of instances that are no more, which are this one's from now on: nobody else
  // finds them, unless this one is killed as well.
  std::vector<std::shared_ptr<Journal>> takeAbandoned();

 private:
  JournalFolder(std::filesystem::path folder, const QString& instance);
  std::filesystem::path pathOf(const QString& instance, const std::string& ending) const;
  void take(const QString& instance, std::vector<std::shared_ptr<Journal>>& taken);

  std::filesystem::path folder_;
  QString instance_;
  QLockFile lock_;
  int count_ = 0;
};

// How many documents' unsaved edits lie in journals that no running instance holds.
int countAbandonedJournals(const std::filesystem::path& folder);

// Removes all journals that no running instance holds. Returns how many files.
int removeAbandonedJournals(const std::filesystem::path& folder);

}  // namespace cutis
