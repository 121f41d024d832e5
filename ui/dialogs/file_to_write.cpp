#include "ui/dialogs/file_to_write.h"

#include <QDir>
#include <QFileDialog>
#include <QFileInfo>
#include <QRegularExpression>

#include "src/app/document/document.h"

namespace cutis {

QString chooseFileToWrite(QWidget* parent, const QString& title, const QString& path,
                          const QString& filters) {
  const QFileInfo suggested(path);
  QFileDialog dialog(parent, title, suggested.path());
  dialog.setAcceptMode(QFileDialog::AcceptSave);
  dialog.setFileMode(QFileDialog::AnyFile);
  dialog.setNameFilters(filters.split(";;"));
  dialog.selectFile(suggested.fileName());
  // The dialog itself appends it, so that it asks before another file is replaced.
  dialog.setDefaultSuffix(extensionOf(dialog.selectedNameFilter()));
  QObject::connect(
      &dialog, &QFileDialog::filterSelected, &dialog,
      [&dialog](const QString& filter) { dialog.setDefaultSuffix(extensionOf(filter)); });
  return dialog.exec() == QDialog::Accepted ? dialog.selectedFiles().value(0) : QString();
}

QString extensionOf(const QString& filter) {
  static const QRegularExpression firstPattern("\\*\\.(\\w+)");
  return firstPattern.match(filter).captured(1);
}

QString besideSource(const Document& document, const QString& name) {
  if (!document.isOpen() || document.sourceFiles().empty()) return name;
  const QFileInfo source(QString::fromStdString(document.sourceFiles().front().string()));
  return source.absoluteDir().filePath(name);
}

}  // namespace cutis
