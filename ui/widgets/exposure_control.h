#pragma once

// The exposure of a picture as a number with its reason, and whether it is found automatically.
// What is typed and cannot be one is marked and explained. Interface thread only.

#include <optional>

#include <QWidget>

class QCheckBox;
class QLabel;

namespace cutis {

class FactorField;

class ExposureControl : public QWidget {
  Q_OBJECT

 public:
  explicit ExposureControl(QWidget* parent = nullptr);

  // Silent. exposure: what is in force. shareInRange: of the pixels, at one that was found.
  void show(double exposure, bool isAutomatic, const std::optional<double>& shareInRange);

 Q_SIGNALS:
  // By the user.
  void chosen(double exposure);
  void automaticWanted();

 private:
  void layOut();

  FactorField* field_;
  QCheckBox* automatic_;
  QLabel* reason_;
  QLabel* message_;
};

}  // namespace cutis
