#include "ui/window/private_data.h"

#include <filesystem>

#include "src/app/project/journal.h"
#include "src/files/io/platform.h"
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
  askQuestion(
      window, QObject::tr("Clear private data?"),
      QObject::tr("Edits that earlier sessions have not saved, what is cached, and the names "
                  "of recent files and folders are removed. Pictures, projects and what is "
                  "open now stay."),
      {{QObject::tr("Clear"), QMessageBox::DestructiveRole, [] { clearPrivateData(); }},
       {QObject::tr("Cancel"), QMessageBox::RejectRole}});
}

}  // namespace cutis
