#include "ui/window/source_finder.h"

#include <QFileDialog>

#include "src/app/document/document.h"
#include "ui/dialogs/format_filters.h"
#include "ui/dialogs/last_folder.h"
#include "ui/dialogs/question.h"
#include "ui/documents/document_page.h"
#include "ui/documents/document_tabs.h"

namespace cutis {
namespace {

QString nameOf(const std::filesystem::path& path) {
  return QString::fromStdString(path.filename().string());
}

// Where it was by what the project says: a project that has moved knows where it was from itself
// and nothing of the place that this leads to now.
QString placeOf(const MissingSource& missing) {
  const auto& file = missing.file;
  const auto named = file.lexically_proximate(missing.path.parent_path());
  if (missing.path.empty() || named.is_absolute()) {
    return SourceFinder::tr("It was in %1.")
        .arg(QString::fromStdString(file.parent_path().string()));
  }
  if (!named.has_parent_path()) return SourceFinder::tr("It was in the project's folder.");
  return SourceFinder::tr("Seen from the project's folder it was %1.")
      .arg(QString::fromStdString(named.generic_string()));
}

// Where to begin to look.
QString folderToSearch(const MissingSource& missing) {
  if (missing.path.empty()) return lastFolder("open");
  return QString::fromStdString(missing.path.parent_path().string());
}

}  // namespace

SourceFinder::SourceFinder(DocumentTabs& tabs, QWidget& window)
    : QObject(&window), tabs_(tabs), window_(window) {}

void SourceFinder::watch(DocumentPage& page) {
  const auto searchFor = [&page](const MissingSource& missing) {
    return Search{missing, missing.path.empty() ? page.journal() : nullptr};
  };
  const Document* document = &page.document();
  connect(document, &Document::sourceMissing, this,
          [this, searchFor](const MissingSource& missing) { ask(searchFor(missing)); });
  connect(document, &Document::otherSourceFound, this,
          [this, searchFor](const MissingSource& missing, const QString& found) {
            askWhetherOther(searchFor(missing), found);
          });
}

void SourceFinder::ask(const Search& search) {
  const MissingSource& missing = search.missing;
  const QString project = missing.path.empty() ? tr("What was not saved") : nameOf(missing.path);
  askQuestion(
      window_, tr("%1 needs %2, which is not there.").arg(project, nameOf(missing.file)),
      tr("%1 If it has moved, choose it at its new place; other files that moved with it are found "
         "by themselves.")
          .arg(placeOf(missing)),
      {{tr("Choose the file…"), QMessageBox::AcceptRole, [this, search] { choose(search); }},
       {tr("Cancel"), QMessageBox::RejectRole}});
}

void SourceFinder::askWhetherOther(const Search& search, const QString& found) {
  askQuestion(
      window_,
      tr("%1 is not the file that the project was saved with.").arg(nameOf(found.toStdString())),
      tr("Its content is another. If you use it, it is fitted again and the edits are kept."),
      {{tr("Choose another…"), QMessageBox::AcceptRole, [this, search] { choose(search); }},
       {tr("Use it"), QMessageBox::DestructiveRole,
        [this, search, found] {
          tabs_.pageToOpenIn().openRelinked(search.missing, found.toStdString(), true,
                                            search.journal);
        }},
       {tr("Cancel"), QMessageBox::RejectRole}});
}

void SourceFinder::choose(const Search& search) {
  const QString name = nameOf(search.missing.file);
  // It may have another name by now. A JSON file is a capture's description or a rig.
  const bool isImage = search.missing.file.extension() != ".json";
  const QString filter =
      isImage ? tr("Images (%1)").arg(readableImagePatterns()) : tr("JSON files (*.json)");
  const QString found = QFileDialog::getOpenFileName(&window_, tr("Where is %1?").arg(name),
                                                     folderToSearch(search.missing),
                                                     filter + ";;" + tr("All files (*)"));
  if (found.isEmpty()) return;
  rememberFolderOf("open", found);
  tabs_.pageToOpenIn().openRelinked(search.missing, found.toStdString(), false, search.journal);
}

}  // namespace cutis
