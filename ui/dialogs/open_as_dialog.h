#pragma once  // internal to ui/dialogs

// How an image is to be read, chosen by a person: layer, colour space, exposure and mask, beside
// what the file says of itself and what is assumed where it says nothing. Interface thread only.

#include <filesystem>

#include <QDialog>

#include "src/app/document/document.h"
#include "src/app/open/image_inspection.h"

class QCheckBox;
class QComboBox;
class QDoubleSpinBox;
class QFormLayout;
class QLabel;
class QPushButton;

namespace cutis {

class FileField;

class OpenAsDialog : public QDialog {
  Q_OBJECT

 public:
  // reason: why a person is asked, a sentence; may be empty.
  OpenAsDialog(const std::filesystem::path& path, const ImageInspection& image,
               const QString& reason, QWidget* parent = nullptr);

  // From now on it is about what is open and was read like this.
  void showInterpretation(const OpenChoice& choice);

  const std::filesystem::path& path() const { return path_; }
  OpenChoice choice() const;

 private:
  QWidget* heading(const QString& reason);
  void addLayer(QFormLayout& form);
  void addColors(QFormLayout& form);
  void addExposure(QFormLayout& form);
  QWidget* buttons();
  const LayerInspection& layer() const;
  // What the file says of the chosen layer, and whether it can be opened like this.
  void showLayer();

  std::filesystem::path path_;
  ImageInspection image_;
  QComboBox* layer_;
  QComboBox* colors_;
  QLabel* statements_;
  QCheckBox* automaticExposure_;
  QDoubleSpinBox* exposure_;
  FileField* mask_;
  QPushButton* open_;
};

}  // namespace cutis
