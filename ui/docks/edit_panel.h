#pragma once

// The five factors of an edit. 1 leaves the skin as it is.

#include <array>

#include <QWidget>

#include "core/skin/profile/parameter.h"

class QCheckBox;
class QMenu;
class QPushButton;

namespace cutis {

class ParameterSlider;

class EditPanel : public QWidget {
  Q_OBJECT

 public:
  explicit EditPanel(QWidget* parent = nullptr);

  // Indexed by Parameter. Silent. Haemoglobins that differ come unlinked, and numbers that were
  // refused are forgotten.
  void setFactors(const std::array<double, kParameterCount>& factors);
  std::array<double, kParameterCount> factors() const;
  // Why nothing can be edited now, which the sliders' tool tips say; empty if it can.
  void setResting(const QString& why);
  // There are edits that no slider shows, which Reset takes away as well.
  void setFurtherEdits(bool any);
  // What the button "Presets" opens; the panel becomes its owner.
  void setPresets(QMenu* menu);

 Q_SIGNALS:
  // By the user; `parameter` is a Parameter. While a slider is dragged stillMoving is true, and the
  // drag ends with one call where it is false. Linked haemoglobins come as two calls, the partner's
  // first and always as still moving.
  void factorChanged(int parameter, double factor, bool stillMoving);
  // What has changed since the last one is to be undone at once.
  void stepEnded();
  void resetWanted();

 private:
  void addSliders();
  void addSlider(Parameter parameter, const QString& toolTip);
  void addFoot();
  void sliderMoved(Parameter parameter, double factor, bool stillMoving);
  void linkToggled(bool linked);
  void updateReset();

  std::array<ParameterSlider*, kParameterCount> sliders_{};
  QCheckBox* link_ = nullptr;
  QPushButton* presets_ = nullptr;
  QPushButton* reset_ = nullptr;
  bool furtherEdits_ = false;
  bool isResting_ = false;
};

}  // namespace cutis
