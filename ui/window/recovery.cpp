#include "ui/window/recovery.h"

#include <QStringList>

#include "src/app/project/manifest.h"
#include "ui/dialogs/question.h"
#include "ui/documents/document_page.h"
#include "ui/documents/document_tabs.h"
#include "ui/widgets/progress_strip.h"

namespace cutis {
namespace {

QString nameOf(const Project& project) {
  if (project.source.path.empty()) return Recovery::tr("the sample face patch");
  return QString::fromStdString(project.source.path.filename().string());
}

}  // namespace

Recovery::Recovery(DocumentTabs& tabs, ProgressStrip& progress, QWidget& window)
    : QObject(&window), tabs_(tabs), progress_(progress), window_(window) {}

Recovery::~Recovery() = default;

void Recovery::begin(const std::filesystem::path& folder) {
  auto opened = JournalFolder::open(folder);
  if (!opened) {
    return progress_.showMessage(QString::fromStdString(opened.error().text()), true);
  }
  journals_ = std::move(opened).value();
  for (DocumentPage* page : tabs_.pages())
    page->keepJournal(journals_->add());
  connect(&tabs_, &DocumentTabs::pageMade, this,
          [this](DocumentPage& page) { page.keepJournal(journals_->add()); });
  offer();
}

void Recovery::offer() {
  std::vector<Left> all;
  QStringList names;
  for (const auto& journal : journals_->takeAbandoned()) {
    const auto project = readProject(journal->path(), {});
    if (project.failed()) {
      progress_.showMessage(QString::fromStdString(project.error().text()), true);
    } else if (project) {
      all.push_back({project.value(), journal});
      names << nameOf(project.value());
    }
  }
  if (all.empty()) return;
  const auto discard = [all] {
    for (const Left& left : all)
      left.journal->erase();
  };
  const auto recoverAll = [this, all] { recover(all); };
  // Whoever turns away without an answer gets the edits back.
  askQuestion(
      window_, tr("Cutis ended while edits were not saved."),
      tr("The edits of %1 can be brought back. They open without a project of their own and "
         "replace no file.")
          .arg(names.join(", ")),
      {{tr("Bring back"), QMessageBox::AcceptRole, recoverAll},
       {tr("Discard"), QMessageBox::DestructiveRole, discard}},
      EscapeAnswer::first);
}

void Recovery::recover(const std::vector<Left>& all) {
  for (const Left& left : all) {
    DocumentPage& page = tabs_.pageToOpenIn();
    page.recover(left.project, left.journal);
  }
}

}  // namespace cutis
