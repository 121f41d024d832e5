#include "ui/window/close_guard.h"

#include <algorithm>
#include <memory>

#include "src/app/document/document.h"
#include "ui/dialogs/question.h"
#include "ui/dialogs/save_controller.h"
#include "ui/documents/document_page.h"
#include "ui/documents/document_tabs.h"
#include "ui/widgets/progress_strip.h"

namespace cutis {
namespace {

using Pages = std::vector<QPointer<DocumentPage>>;

template <typename Condition>
Pages those(const Pages& pages, const Condition& condition) {
  Pages chosen;
  for (const auto& page : pages) {
    if (page && condition(*page)) chosen.push_back(page);
  }
  return chosen;
}

bool isWriting(DocumentPage& page) {
  return page.isWriting();
}

bool isModified(DocumentPage& page) {
  return page.document().isModified();
}

constexpr char kWaitingTopic[] = "close when written";

std::size_t lostWritesOf(const Pages& pages) {
  std::size_t lost = 0;
  for (const auto& page : pages)
    lost += page ? page->lostWrites() : 0;
  return lost;
}

// "face", "face and hand", "face, hand and 2 more".
QString namesOf(const Pages& pages) {
  QStringList names;
  for (const auto& page : pages)
    names << page->document().name();
  if (names.size() == 1) return names.first();
  if (names.size() > 3) {
    return CloseGuard::tr("%1, %2 and %3 more").arg(names[0], names[1]).arg(names.size() - 2);
  }
  const QString last = names.takeLast();
  return CloseGuard::tr("%1 and %2").arg(names.join(", "), last);
}

}  // namespace

CloseGuard::CloseGuard(DocumentTabs& tabs, ProgressStrip& progress, QWidget& window)
    : QObject(&window), tabs_(tabs), progress_(progress), window_(window) {}

void CloseGuard::closePage(DocumentPage& page) {
  const QPointer<DocumentPage> closed(&page);
  close({closed}, [this, closed] {
    if (closed) tabs_.close(*closed);
  });
}

bool CloseGuard::mayClose() {
  if (isAnswered_) return true;
  Pages pages;
  for (DocumentPage* page : tabs_.pages())
    pages.emplace_back(page);
  if (those(pages, isWriting).empty() && those(pages, isModified).empty()) return true;
  close(pages, [this] {
    isAnswered_ = true;
    window_.close();
  });
  return false;
}

void CloseGuard::close(const Pages& pages, const std::function<void()>& go) {
  // One that is answered is gone a moment later.
  if (question_ && question_->isVisible()) {
    question_->raise();
    return question_->activateWindow();
  }
  const Pages writing = those(pages, isWriting);
  if (!writing.empty()) return askToWait(writing, pages, go);
  const Pages modified = those(pages, isModified);
  if (!modified.empty()) return askToSave(modified, pages, go);
  go();
}

void CloseGuard::askToWait(const Pages& writing, const Pages& pages,
                           const std::function<void()>& go) {
  const std::size_t lost = lostWritesOf(writing);
  question_ = askQuestion(
      window_, tr("A file of %1 is still being written.").arg(namesOf(writing)),
      tr("Cutis can close as soon as it is done. If you stop it now, the file is not written."),
      {{tr("Wait and close"), QMessageBox::AcceptRole,
        [this, writing, lost, pages, go] {
          progress_.showMessage(tr("Closes when the file is written."), false, kWaitingTopic);
          waitFor(writing, lost, pages, go);
        }},
       {tr("Stop writing"), QMessageBox::DestructiveRole,
        [this, writing, pages, go] {
          for (const auto& page : writing) {
            if (page) page->stopWriting();
          }
          close(pages, go);
        }},
       {tr("Cancel"), QMessageBox::RejectRole}});
}

void CloseGuard::waitFor(const Pages& writing, std::size_t lost, const Pages& pages,
                         const std::function<void()>& go) {
  if (lostWritesOf(writing) > lost) return progress_.withdraw(kWaitingTopic);
  const Pages left = those(writing, isWriting);
  if (left.empty()) {
    progress_.withdraw(kWaitingTopic);
    return close(pages, go);
  }
  connect(
      &left.front()->jobs(), &JobRunner::finished, this,
      [this, writing, lost, pages, go] { waitFor(writing, lost, pages, go); },
      static_cast<Qt::ConnectionType>(Qt::QueuedConnection | Qt::SingleShotConnection));
}

void CloseGuard::askToSave(const Pages& modified, const Pages& pages,
                           const std::function<void()>& go) {
  const bool isOne = modified.size() == 1;
  const auto discard = [this, modified, pages, go] {
    for (const auto& page : modified) {
      if (page) page->discardEdits();
    }
    go();
  };
  question_ = askQuestion(window_, tr("Save the changes of %1?").arg(namesOf(modified)),
                          tr("What is not saved as a project is lost."),
                          {{isOne ? tr("Save") : tr("Save all"), QMessageBox::AcceptRole,
                            [this, modified, pages, go] { saveOneByOne(modified, pages, go); }},
                           {tr("Discard"), QMessageBox::DestructiveRole, discard},
                           {tr("Cancel"), QMessageBox::RejectRole}});
}

void CloseGuard::saveOneByOne(Pages modified, const Pages& pages, const std::function<void()>& go) {
  modified = those(modified, isModified);
  if (modified.empty()) return close(pages, go);
  DocumentPage& page = *modified.front();
  tabs_.present(page);
  // Not from within the page's own signal, as it may be closed then.
  page.saves().saveThen([this, modified, pages, go](bool saved) {
    if (!saved) return;
    QMetaObject::invokeMethod(
        this, [this, modified, pages, go] { saveOneByOne(modified, pages, go); },
        Qt::QueuedConnection);
  });
}

}  // namespace cutis
