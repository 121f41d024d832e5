#pragma once

// What is in the spectrum dock: the plot, the table of pins beside it, and above them a bar with
// what is drawn and how large the squares are whose mean is shown. In a dock that has no room for
// both the table takes the place of the plot; in a narrow one the bar leaves out what the menus
// have, too. Interface thread only.

#include <QWidget>

#include "ui/plot/spectrum_figure.h"

class QComboBox;
class QLabel;
class QMenu;
class QPushButton;
class QToolButton;

namespace cutis {

class PinTable;
class SpectrumPlot;

class SpectrumPanel : public QWidget {
  Q_OBJECT

 public:
  explicit SpectrumPanel(QWidget* parent = nullptr);

  SpectrumPlot& plot() { return *plot_; }
  PinTable& table() { return *table_; }
  // A side of the squares, of those that pins can have; emits nothing.
  void setSize(int size);
  // What can be taken out of the program.
  void setExports(QMenu* menu);

 Q_SIGNALS:
  void sizeChosen(int size);
  void quantityChosen(cutis::SpectrumQuantity quantity);

 protected:
  void resizeEvent(QResizeEvent* event) override;

 private:
  void makeBar();
  void makeQuantities();
  void makeSizes();
  void arrange();
  void fitBar();

  QWidget* bar_;
  QComboBox* quantities_;
  QLabel* sizeLabel_;
  QComboBox* sizes_;
  QToolButton* tableButton_;
  QPushButton* exportButton_;
  SpectrumPlot* plot_;
  PinTable* table_;
};

}  // namespace cutis
