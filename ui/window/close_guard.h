#pragma once  // internal to ui/window

// Before a document goes, by its tab or with the whole window: what is being written is waited for,
// and what is not saved is asked about, once. Whatever cannot be written keeps it open. Interface
// thread only.

#include <cstddef>
#include <functional>
#include <vector>

#include <QMessageBox>
#include <QObject>
#include <QPointer>

namespace cutis {

class DocumentPage;
class DocumentTabs;
class ProgressStrip;

class CloseGuard : public QObject {
  Q_OBJECT

 public:
  // All outlive the guard.
  CloseGuard(DocumentTabs& tabs, ProgressStrip& progress, QWidget& window);

  // Closes the page, at once or when all is answered and written.
  void closePage(DocumentPage& page);
  // Whether the window may close at once. If not, it is closed when all is answered and written.
  bool mayClose();

 private:
  using Pages = std::vector<QPointer<DocumentPage>>;

  void close(const Pages& pages, const std::function<void()>& go);
  void askToWait(const Pages& writing, const Pages& pages, const std::function<void()>& go);
  // lost: of the writing pages, when it began. What is lost meanwhile keeps them open.
  void waitFor(const Pages& writing, std::size_t lost, const Pages& pages,
               const std::function<void()>& go);
  void askToSave(const Pages& modified, const Pages& pages, const std::function<void()>& go);
  void saveOneByOne(Pages modified, const Pages& pages, const std::function<void()>& go);

  DocumentTabs& tabs_;
  ProgressStrip& progress_;
  QWidget& window_;
  QPointer<QMessageBox> question_;
  bool isAnswered_ = false;  // the window closes now
};

}  // namespace cutis
