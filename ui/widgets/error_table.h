#pragma once

// The errors of trained networks as a table. Interface thread only.

#include <QWidget>

#include "src/app/training/network_errors.h"

class QGridLayout;
class QLabel;

namespace cutis {

// What the command train prints at its end, in percent of a perfect diffuser and in words. Tool
// tips have the mean squared errors.
class ErrorTable : public QWidget {
  Q_OBJECT

 public:
  explicit ErrorTable(QWidget* parent = nullptr);

  void setErrors(const NetworkErrors& errors);

 private:
  void addRow(int row, const QString& name, const QString& toolTip, QLabel* clean, QLabel* noisy);

  QGridLayout* grid_;
  QLabel* verdict_;
  QLabel* maps_;
  QLabel* mapsNoisy_;
  QLabel* spectra_;
  QLabel* both_;
  QLabel* bothNoisy_;
};

// "0.12 %": the root of a mean squared error of reflectance.
QString errorText(double meanSquaredError);

}  // namespace cutis
