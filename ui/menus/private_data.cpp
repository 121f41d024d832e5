#include "ui/menus/private_data.h"

#include <filesystem>

#include "src/app/project/journal.h"
#include "src/files/system/platform.h"
#include "ui/dialogs/last_folder.h"
#include "ui/dialogs/open_controller.h"
#include "ui/dialogs/question.h"

namespace cutis {

void clearPrivateData() {
  removeAbandonedJournals(journalFolder());
  std::error_code ignored;
  if (!cacheFolder().empty()) std::filesystem::remove_all(cacheFolder(), ignored);
  forgetRecentFiles();
  forgetFolders();
}

void askToClearPrivateData(QWidget& window) {
  const int lost = countAbandonedJournals(journalFolder());
  const QString edits =
      lost == 0   ? QObject::tr("No unsaved edits of earlier sessions are kept.")
      : lost == 1 ? QObject::tr("The unsaved edits of one document of an earlier session are lost.")
                  : QObject::tr("The unsaved edits of %1 documents of earlier sessions are lost.")
                        .arg(lost);
  askQuestion(
      window, QObject::tr("Clear private data?"),
      QObject::tr("%1 What is cached and the names of recent files and folders are removed. "
                  "Pictures, projects and what is open now stay.")
          .arg(edits),
      {{QObject::tr("Cancel"), QMessageBox::RejectRole},
       {QObject::tr("Clear"), QMessageBox::DestructiveRole, [] { clearPrivateData(); }}},
      EscapeAnswer::first);
}

}  // namespace cutis
