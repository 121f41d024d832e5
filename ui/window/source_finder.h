#pragma once  // internal to ui/window

// Asks where a file is now that a project does not find. Another file than the project was saved
// with is taken only after that was said. Interface thread only.

#include <memory>

#include <QObject>

#include "src/app/project/journal.h"
#include "src/app/project/project_open.h"

class QWidget;

namespace cutis {

class DocumentPage;
class DocumentTabs;

class SourceFinder : public QObject {
  Q_OBJECT

 public:
  // Both outlive it; questions stand before the window.
  SourceFinder(DocumentTabs& tabs, QWidget& window);

  void watch(DocumentPage& page);

 private:
  // What a journal kept stays with its journal.
  struct Search {
    MissingSource missing;
    std::shared_ptr<Journal> journal;  // null for a project
  };

  void ask(const Search& search);
  void askWhetherOther(const Search& search, const QString& found);
  void choose(const Search& search);

  DocumentTabs& tabs_;
  QWidget& window_;
};

}  // namespace cutis
