#pragma once

// The documents of the window, each on a page behind a tab of its own. There is always a current
// page; it is blank while nothing is open. A document has its tab from the moment when it can be
// shown, so that what cannot be opened changes nothing; it comes to the front then, unless somebody
// is in the middle of a gesture. Of several that are opened at once the first does. Interface
// thread only.

#include <filesystem>
#include <functional>
#include <set>
#include <vector>

#include <QWidget>

#include "src/app/document/document.h"

class QStackedWidget;
class QTabBar;

namespace cutis {

class DocumentPage;

class DocumentTabs : public QWidget {
  Q_OBJECT

 public:
  using MakePage = std::function<DocumentPage*(QWidget* parent)>;

  explicit DocumentTabs(MakePage makePage, QWidget* parent = nullptr);
  ~DocumentTabs() override;

  // Makes the first page. Once, before everything else.
  void begin();

  DocumentPage& current() const;
  // In no order; those whose document is still being read among them.
  std::vector<DocumentPage*> pages() const;
  int count() const;  // of tabs

  // Opens a file, or the sample where the path is empty, on the current page if that is blank, else
  // behind a tab of its own. What is open already is presented.
  void open(const std::filesystem::path& path);
  // The same, read as somebody has chosen, whether it is open already or not.
  void openAs(const std::filesystem::path& path, const OpenChoice& choice);
  // The page that something is to be opened in: the current one if it is blank, else a new one.
  DocumentPage& pageToOpenIn();
  // Precondition: the page has a tab.
  void present(DocumentPage& page);
  // The next tab to the right, or to the left for -1, and round at the ends.
  void step(int direction);
  // Its document goes, without a question; a blank page takes the place of the last one.
  void close(DocumentPage& page);
  // Shows what the document of a page is called now.
  void refreshTitles();

 Q_SIGNALS:
  // Once for each new page, before anything is opened in it.
  void pageMade(cutis::DocumentPage& page);
  // Another page is current, or the document of the current one has been opened or closed.
  void currentChanged();
  // By the button of a tab or the middle button of the mouse.
  void closeWanted(cutis::DocumentPage& page);
  // It can be shown, but stays behind: somebody is in the middle of something else.
  void openedBehind(cutis::DocumentPage& page);

 private:
  DocumentPage& makePage();
  // -1 if the page has no tab.
  int tabOf(const DocumentPage& page) const;
  DocumentPage& pageOf(int tab) const;
  void takeOpened(DocumentPage& page);
  void addTab(DocumentPage& page);
  void beginBatch();
  QString titleOf(const Document& document) const;
  // Removes what is blank and not in sight.
  void discardBlankPages();
  void makeCurrent(DocumentPage& page);

  MakePage makePage_;
  QTabBar* bar_;
  QStackedWidget* stack_;
  // Pages that were asked for together with another one, which alone comes to the front.
  std::set<const DocumentPage*> behind_;
  bool isBatchBegun_ = false;
};

}  // namespace cutis
