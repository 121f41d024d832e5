#pragma once

// How the skin is fitted: profile of the skin model, method, exposure, shading. What cannot be is
// disabled and its tool tip says why.

#include <QMetaType>
#include <QWidget>

#include "src/app/open/fit_choice.h"

class QCheckBox;
class QComboBox;
class QFormLayout;
class QPushButton;

namespace cutis {

class ExposureControl;

class FitPanel : public QWidget {
  Q_OBJECT

 public:
  // What kind of source the choice is for.
  enum class Subject {
    photographs,
    texture,
    maps,  // they were opened as such and stay what they are
  };

  explicit FitPanel(QWidget* parent = nullptr);

  // Silent. A profile that is not offered yet, a file, is offered as long as it is shown, and after
  // keepProfile() from then on. Takes an offer of training back.
  void show(const FitChoice& choice, Subject subject);
  // For a texture: the exposure in force and, where it was found, the share of the pixels that it
  // brings into the range of skin. Silent.
  void showExposure(double exposure, const std::optional<double>& shareInRange);
  // The profile that is shown has turned out to be good.
  void keepProfile() { tried_.clear(); }
  FitChoice choice() const;

  // Whether there is something to fit that nobody is fitting: the button is there then.
  void setFitOffered(bool offered);
  // There is no network for what is fitted.
  void offerTraining();

 Q_SIGNALS:
  // By the user, also where the choice is what it was.
  void changed(const cutis::FitChoice& choice);
  void loadWanted();
  void fitWanted();
  void optionsWanted();
  void trainingOffered();
  void trainingWanted();

 private:
  void addForm();
  void addOffer();
  void connectControls();
  void offerProfile(const QString& profile);
  void showProfile(const QString& profile, Subject subject);
  void showMethod(const FitChoice& choice);
  void showShading(const FitChoice& choice, Subject subject);
  void showOptions(const FitChoice& choice);

  QComboBox* profile_;
  QPushButton* load_;
  QFormLayout* form_;
  QComboBox* method_;
  ExposureControl* exposure_;
  QCheckBox* shading_;
  QPushButton* fit_;
  QPushButton* options_;
  QWidget* offer_;
  FitChoice shown_;  // with what the panel has no control for
  QString tried_;    // offered, but nobody knows yet whether it is a profile
};

}  // namespace cutis

Q_DECLARE_METATYPE(cutis::FitChoice)
