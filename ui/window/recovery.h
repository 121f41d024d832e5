#pragma once  // internal to ui/window

// Edits that a crash would lose: gives each page a journal, and offers once what an earlier crash
// has left. Interface thread only.

#include <filesystem>
#include <memory>
#include <vector>

#include <QObject>

#include "src/app/project/journal.h"
#include "src/app/project/project.h"

class QWidget;

namespace cutis {

class DocumentPage;
class DocumentTabs;
class ProgressStrip;

class Recovery : public QObject {
  Q_OBJECT

 public:
  // All outlive it; the question stands before the window.
  Recovery(DocumentTabs& tabs, ProgressStrip& progress, QWidget& window);
  ~Recovery() override;

  // From now on journals are kept in the folder, by all pages. Once.
  void begin(const std::filesystem::path& folder);

 private:
  struct Left {
    Project project;
    std::shared_ptr<Journal> journal;
  };

  void offer();
  void recover(const std::vector<Left>& all);

  DocumentTabs& tabs_;
  ProgressStrip& progress_;
  QWidget& window_;
  std::unique_ptr<JournalFolder> journals_;
};

}  // namespace cutis
