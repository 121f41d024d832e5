#include "ui/view/band_scrubber.h"

#include <algorithm>
#include <cmath>

#include <QGridLayout>
#include <QLabel>
#include <QPainter>
#include <QSlider>

#include "core/spectra/grid.h"
#include "ui/theme/theme.h"

namespace cutis {
namespace {

constexpr int kScrubberWidth = 360;
constexpr int kFirstSample = 125;  // 550 nm

}  // namespace

BandScrubber::BandScrubber(QWidget* parent)
    : QWidget(parent),
      slider_(new QSlider(Qt::Horizontal, this)),
      number_(new QLabel(this)),
      kind_(new QLabel(this)) {
  auto* grid = new QGridLayout(this);
  grid->setContentsMargins(10, 8, 10, 8);
  grid->setVerticalSpacing(theme::kHalfSpace);
  grid->addWidget(number_, 0, 0);
  grid->addWidget(kind_, 0, 1, Qt::AlignRight);
  grid->addWidget(slider_, 1, 0, 1, 2);
  theme::dimText(*kind_);
  slider_->setAccessibleName(tr("Wavelength"));
  slider_->setRange(0, kSampleCount - 1);
  slider_->setPageStep(25);
  slider_->setValue(kFirstSample);
  connect(slider_, &QSlider::valueChanged, this, [this] {
    describe();
    Q_EMIT wavelengthChosen(wavelengthNm());
  });
  describe();
  hide();
}

double BandScrubber::wavelengthNm() const {
  return cutis::wavelengthNm(slider_->value());
}

void BandScrubber::setWavelengthNm(double wavelength) {
  const Band sample = bandBetween(wavelength - 1.0, wavelength + 1.0);
  if (sample.count() > 0) slider_->setValue(sample.first);
}

void BandScrubber::setWanted(bool wanted) {
  setVisible(wanted);
}

void BandScrubber::describe() {
  const bool isVisible = kVisibleBand.contains(slider_->value());
  number_->setText(tr("%1 nm").arg(wavelengthNm(), 0, 'f', 0));
  kind_->setText(isVisible ? tr("visible") : tr("predicted beyond the visible"));
  slider_->setAccessibleDescription(tr("%1, %2").arg(number_->text(), kind_->text()));
}

void BandScrubber::place(int left, const QSize& view) {
  const int from = left + theme::kDoubleSpace;
  const int width = std::min(kScrubberWidth, view.width() - from - theme::kDoubleSpace);
  const int height = sizeHint().height();
  // Where there is no room beside it, above.
  if (width < minimumSizeHint().width()) {
    setGeometry(theme::kDoubleSpace, theme::kDoubleSpace,
                std::min(kScrubberWidth, view.width() - 2 * theme::kDoubleSpace), height);
    return;
  }
  setGeometry(from, view.height() - theme::kDoubleSpace - height, width, height);
}

void BandScrubber::paintEvent(QPaintEvent*) {
  QPainter painter(this);
  painter.setRenderHint(QPainter::Antialiasing);
  painter.setPen(Qt::NoPen);
  painter.setBrush(QColor(0x14, 0x14, 0x14, 0xd8));
  painter.drawRoundedRect(QRectF(rect()), theme::kCornerRadius, theme::kCornerRadius);
}

}  // namespace cutis
