#include "ui/dialogs/file_to_write.h"

#include <string>
#include <vector>

#include <QDir>
#include <QFileDialog>
#include <QFileInfo>
#include <QMessageBox>
#include <QRegularExpression>

#include "src/app/document/document.h"
#include "src/app/export/overwrite_protection.h"

namespace cutis {

namespace {

// Says what speaks against a file before anybody is asked whether it may be replaced.
class FileDialog : public QFileDialog {
 public:
  FileDialog(QWidget* parent, const QString& title, const QString& folder,
             const FileObjection& objection)
      : QFileDialog(parent, title, folder), objection_(objection) {}

 protected:
  void accept() override {
    const QString file = selectedFiles().value(0);
    const QString sentence = objection_ ? objection_(file) : QString();
    if (sentence.isEmpty()) return QFileDialog::accept();
    QMessageBox::warning(this, windowTitle(), sentence);
  }

 private:
  const FileObjection& objection_;
};

}  // namespace

QString chooseFileToWrite(QWidget* parent, const QString& title, const QString& path,
                          const QString& filters, const FileObjection& objection) {
  const QFileInfo suggested(path);
  FileDialog dialog(parent, title, suggested.path(), objection);
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

QString besideSourceNamedAfter(const Document& document, const QString& what) {
  const QString name = QFileInfo(document.name()).completeBaseName();
  return besideSource(document, QString("%1_%2").arg(name, what));
}

QString objectionToWriting(const Document& document, const QString& path) {
  std::vector<std::string> sources;
  for (const std::filesystem::path& file : document.sourceFiles())
    sources.push_back(file.string());
  const Status allowed = checkNotInput(path.toStdString(), sources);
  return allowed.failed() ? QString::fromStdString(allowed.error().text()) : QString();
}

}  // namespace cutis
