#pragma once

// What of a fit few people change: the lights of a capture that are used and what became of the
// surface's reflection, the noise that is assumed, what is known beforehand, what is
// held and what is found besides. Interface thread only.

#include <array>
#include <string>
#include <vector>

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

// The lights of a capture, by their names, and those of them that are used.
struct CaptureLights {
  std::vector<std::string> all;
  std::vector<std::string> used;
};

class FitOptionsDialog : public QDialog {
  Q_OBJECT

 public:
  // `usualNoise`: the rig's. The profile is the choice's. `lights`: empty for what is no capture,
  // which has neither lights to choose nor a reflection of its surface.
  FitOptionsDialog(const FitChoice& choice, const Profile& profile,
                   const std::array<double, 2>& usualNoise, const CaptureLights& lights,
                   QWidget* parent = nullptr);

  // The choice as it stands now; the method is refined where an option needs it.
  FitChoice choice() const;
  // Those to use; empty: all.
  std::vector<std::string> lights() const;

 private:
  struct HeldRow {
    QCheckBox* held;
    QDoubleSpinBox* value;
  };

  void addCapture(QFormLayout& form, const CaptureLights& lights);
  void addNoise(QFormLayout& form, const std::array<double, 2>& usual);
  void addHeld(QFormLayout& form);
  void addFound(QFormLayout& form);
  QWidget* buttons();
  void take(const FitChoice& choice);
  void orderTabs();
  void takeSpecular(const FitChoice& choice);
  void addSpecular(FitChoice& choice) const;
  void check();
  QString objection() const;

  FitChoice base_;
  Profile profile_;
  std::array<double, 2> usualNoise_;
  std::vector<QCheckBox*> lights_;  // none for what is no capture
  QComboBox* specular_;
  QDoubleSpinBox* share_;
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
