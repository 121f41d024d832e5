#include "ui/dialogs/file_field.h"

#include <QFileDialog>
#include <QHBoxLayout>
#include <QLineEdit>
#include <QPushButton>

#include "ui/dialogs/format_filters.h"
#include "ui/theme/theme.h"

namespace cutis {

FileField::FileField(const FileFieldTexts& texts, const std::filesystem::path& folder,
                     QWidget* parent)
    : QWidget(parent),
      texts_(texts),
      folder_(QString::fromStdString(folder.string())),
      line_(new QLineEdit(this)) {
  line_->setPlaceholderText(texts.placeholder);
  line_->setClearButtonEnabled(true);
  line_->setAccessibleName(texts.name);
  line_->setToolTip(texts.toolTip);
  setFocusProxy(line_);
  auto* browse = new QPushButton(tr("C&hoose…"), this);
  browse->setAutoDefault(false);
  connect(browse, &QPushButton::clicked, this, &FileField::choose);
  auto* row = new QHBoxLayout(this);
  row->setContentsMargins(0, 0, 0, 0);
  row->setSpacing(theme::kSpace);
  row->addWidget(line_, 1);
  row->addWidget(browse);
}

std::filesystem::path FileField::path() const {
  return line_->text().toStdString();
}

void FileField::setPath(const std::filesystem::path& path) {
  line_->setText(QString::fromStdString(path.string()));
}

void FileField::choose() {
  const QString file =
      QFileDialog::getOpenFileName(this, texts_.dialogTitle, folder_, texts_.filter);
  if (!file.isEmpty()) line_->setText(file);
}

FileFieldTexts maskTexts() {
  return {FileField::tr("Mask"), FileField::tr("None"),
          FileField::tr("A picture of the same size: black is left out"),
          FileField::tr("Choose mask"),
          FileField::tr("Images (%1);;All files (*)").arg(readableImagePatterns())};
}

}  // namespace cutis
