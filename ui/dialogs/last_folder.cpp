#include "ui/dialogs/last_folder.h"

#include <QFileInfo>
#include <QSettings>

namespace cutis {
namespace {

constexpr char kGroup[] = "lastFolder";

QString keyOf(const QString& kind) {
  return QString(kGroup) + "/" + kind;
}

}  // namespace

QString lastFolder(const QString& kind) {
  const QString folder = QSettings().value(keyOf(kind)).toString();
  return QFileInfo(folder).isDir() ? folder : QString();
}

void rememberFolderOf(const QString& kind, const QString& file) {
  QSettings().setValue(keyOf(kind), QFileInfo(file).absolutePath());
}

void forgetFolders() {
  QSettings().remove(kGroup);
}

}  // namespace cutis
