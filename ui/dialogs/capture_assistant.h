#pragma once  // internal to ui/dialogs

// Asks which photograph was taken under which light, and writes the answer as capture.json. What is
// proposed is a guess that the user sees and may change. Interface thread only.

#include <QDialog>

#include "core/rig/rig.h"
#include "src/app/open/capture_candidates.h"
#include "src/images/capture/capture_description.h"

class QCheckBox;
class QComboBox;
class QGridLayout;
class QLabel;
class QPushButton;

namespace cutis {

class FileField;

class CaptureAssistant : public QDialog {
  Q_OBJECT

 public:
  // Precondition: at least one photograph.
  explicit CaptureAssistant(const CaptureCandidates& candidates, QWidget* parent = nullptr);

  // Where capture.json comes to stand.
  const std::filesystem::path& folder() const { return folder_; }
  // As it stands now.
  CaptureDescription description() const;

 Q_SIGNALS:
  // Instead of as one capture.
  void eachWanted(const std::vector<std::filesystem::path>& files);

 private:
  struct Row {
    QLabel* thumbnail;
    QComboBox* light;
    QLabel* clue;
  };

  QWidget* heading();
  QWidget* photographs();
  void addPhotograph(QGridLayout& grid, const CandidatePhotograph& photograph);
  QLayout* form();
  QWidget* buttons();
  void takeRig();
  void chooseRig();
  void fillLights();
  void showThumbnails();
  void check();
  QString objection() const;

  CaptureCandidates candidates_;
  std::filesystem::path folder_;
  Rig rig_;
  std::vector<Row> rows_;
  QComboBox* rigs_;
  QComboBox* encoding_;
  FileField* mask_;
  QLabel* note_;
  QPushButton* write_;
};

}  // namespace cutis
