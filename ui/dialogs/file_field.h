#pragma once  // internal to ui/dialogs

// A field for the path of a file that need not be given, with a button that looks for one.
// Interface thread only.

#include <filesystem>

#include <QWidget>

class QLineEdit;

namespace cutis {

struct FileFieldTexts {
  QString name;         // for those who hear the window
  QString placeholder;  // what holds while the field is empty
  QString toolTip;
  QString dialogTitle;
  QString filter;  // of the dialog
};

class FileField : public QWidget {
  Q_OBJECT

 public:
  // The dialog begins in `folder`, if that is not empty.
  FileField(const FileFieldTexts& texts, const std::filesystem::path& folder,
            QWidget* parent = nullptr);

  std::filesystem::path path() const;
  void setPath(const std::filesystem::path& path);

 private:
  void choose();

  FileFieldTexts texts_;
  QString folder_;
  QLineEdit* line_;
};

// For a mask of a picture.
FileFieldTexts maskTexts();

}  // namespace cutis
