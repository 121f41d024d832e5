#pragma once

// What of a fit few people change: the noise that is assumed, what is known beforehand, what is
// held and what is found besides. Interface thread only.

#include <array>

#include <QDialog>

#include "core/skin/profile/profile.h"
#include "src/app/open/fit_choice.h"

class QCheckBox;
class QComboBox;
class QDoubleSpinBox;
class QFormLayout;
class QLabel;
class QPushButton;

namespace cutis {

class Document;
class FileField;

class FitOptionsDialog : public QDialog {
  Q_OBJECT

 public:
  // `usualNoise`: the rig's. The profile is the choice's.
  FitOptionsDialog(const FitChoice& choice, const Profile& profile,
                   const std::array<double, 2>& usualNoise, QWidget* parent = nullptr);

  // The choice as it stands now; the method is refined where an option needs it.
  FitChoice choice() const;

 private:
  struct HeldRow {
    QCheckBox* held;
    QDoubleSpinBox* value;
  };

  void addNoise(QFormLayout& form, const std::array<double, 2>& usual);
  void addHeld(QFormLayout& form);
  void addFound(QFormLayout& form);
  QWidget* buttons();
  void take(const FitChoice& choice);
  void check();
  QString objection() const;

  FitChoice base_;
  Profile profile_;
  std::array<double, 2> usualNoise_;
  QComboBox* noise_;
  std::array<QDoubleSpinBox*, 2> deviations_;
  FileField* prior_;
  std::array<HeldRow, kParameterCount> held_;
  QCheckBox* oxygenation_;
  QCheckBox* thickness_;
  QComboBox* discrepancy_;
  QLabel* note_;
  QPushButton* fit_;
};

// Asks before the window, and fits with the answer. Precondition: the document has something to
// fit.
void askForFitOptions(Document& document, QWidget& window);

}  // namespace cutis
