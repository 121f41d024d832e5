#include "ui/window/recovery.h"

#include <QDateTime>
#include <QFileInfo>
#include <QLocale>
#include <QStringList>

#include "src/app/project/manifest.h"
#include "ui/dialogs/question.h"
#include "ui/documents/document_page.h"
#include "ui/documents/document_tabs.h"
#include "ui/view/view_catalogue.h"
#include "ui/widgets/progress_strip.h"

namespace cutis {
namespace {

QString nameOf(const Project& project) {
  const auto& path = project.editsOf.empty() ? project.source.path : project.editsOf;
  if (path.empty()) return Recovery::tr("the sample face patch");
  return QString::fromStdString(path.filename().string());
}

// "today 14:05"
QString timeOf(const std::filesystem::path& journal) {
  const QDateTime written = QFileInfo(QString::fromStdString(journal.string())).lastModified();
  const QLocale locale;
  const QString clock = locale.toString(written.time(), QLocale::ShortFormat);
  if (written.date() == QDate::currentDate()) return Recovery::tr("today %1").arg(clock);
  return QString("%1 %2").arg(locale.toString(written.date(), QLocale::ShortFormat), clock);
}

// "face.cutis and hand.png"
QString joinedByAnd(QStringList names) {
  const QString last = names.takeLast();
  return names.isEmpty() ? last : Recovery::tr("%1 and %2").arg(names.join(", "), last);
}

// One in which the edits are seen.
ProjectView seenIn(const Project& project) {
  ProjectView view = project.view;
  const auto kind = viewById(QString::fromStdString(view.view));
  if (kind && kind != ViewKind::photograph) return view;
  const bool hasAlbedo = project.source.kind != SourceKind::maps;
  view.view = describe(hasAlbedo ? ViewKind::editedAlbedo : ViewKind::skin).id.toStdString();
  return view;
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
      names << tr("%1 (%2)").arg(nameOf(project.value()), timeOf(journal->path()));
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
          .arg(joinedByAnd(names)),
      {{tr("Bring back"), QMessageBox::AcceptRole, recoverAll},
       {tr("Discard"), QMessageBox::DestructiveRole, discard}},
      EscapeAnswer::first);
}

void Recovery::recover(const std::vector<Left>& all) {
  for (const Left& left : all) {
    DocumentPage& page = tabs_.pageToOpenIn();
    Project project = left.project;
    project.view = seenIn(project);
    page.recover(project, left.journal);
  }
}

}  // namespace cutis
