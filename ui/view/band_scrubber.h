#pragma once  // internal to ui/view

// A slider in the picture for the wavelength of a single band, 300 to 1000 nm in steps of the grid,
// with the number and whether it was measured or is predicted. Interface thread only.

#include <QWidget>

class QLabel;
class QSlider;

namespace cutis {

class BandScrubber : public QWidget {
  Q_OBJECT

 public:
  explicit BandScrubber(QWidget* parent = nullptr);

  double wavelengthNm() const;
  void setWavelengthNm(double wavelength);
  // Hidden unless it is.
  void setWanted(bool wanted);
  // Its place at the foot of a view of this size, to the right of what ends there.
  void place(int left, const QSize& view);

 Q_SIGNALS:
  void wavelengthChosen(double wavelengthNm);

 protected:
  void paintEvent(QPaintEvent* event) override;
  void mousePressEvent(QMouseEvent*) override {}

 private:
  void describe();

  QSlider* slider_;
  QLabel* number_;
  QLabel* kind_;
};

}  // namespace cutis
