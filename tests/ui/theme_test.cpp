// What the theme promises to people who see less well (WCAG 2.1, 1.4.3 and 1.4.11).

#include "ui/theme/theme.h"

#include <cmath>

#include <QCheckBox>
#include <QFontMetrics>
#include <QHelpEvent>
#include <QImage>
#include <QLineEdit>
#include <QSpinBox>
#include <QToolTip>
#include <QWheelEvent>
#include <QtTest>

#include "tests/support/expect.h"
#include "tests/support/test_registry.h"
#include "tests/ui/ui_test.h"
#include "ui/widgets/neutral_slider.h"

namespace cutis {
namespace {

double linear(double encoded) {
  return encoded <= 0.04045 ? encoded / 12.92 : std::pow((encoded + 0.055) / 1.055, 2.4);
}

double luminance(const QColor& color) {
  return 0.2126 * linear(color.redF()) + 0.7152 * linear(color.greenF()) +
         0.0722 * linear(color.blueF());
}

double contrast(const QColor& a, const QColor& b) {
  const double brighter = std::max(luminance(a), luminance(b)) + 0.05;
  return brighter / (std::min(luminance(a), luminance(b)) + 0.05);
}

// The largest against `ground` along a line of the picture.
double contrastAlong(const QImage& picture, int y, const QColor& ground) {
  double best = 1;
  for (int x = 0; x < picture.width(); ++x)
    best = std::max(best, contrast(picture.pixelColor(x, y), ground));
  return best;
}

class ThemeTest : public test::UiTest {
  Q_OBJECT

 private slots:
  // Qt shows a plain sentence as one line, however long.
  void longToolTipsAreBrokenIntoLines() {
    QWidget widget;
    widget.setToolTip(
        QStringLiteral("A sentence with 3 < 4 that is about twice as long as what one "
                       "can take in at a glance, and that tells what happens."));
    widget.show();
    QHelpEvent help(QEvent::ToolTip, {5, 5}, widget.mapToGlobal(QPoint(5, 5)));
    QCoreApplication::sendEvent(&widget, &help);
    QVERIFY(QToolTip::isVisible());
    const QWidget* tip = nullptr;
    for (const QWidget* top : QApplication::topLevelWidgets()) {
      if (top->inherits("QTipLabel")) tip = top;
    }
    QVERIFY(tip);
    const QFontMetrics font(tip->font());
    EXPECT_AT_MOST(tip->width(), font.averageCharWidth() * 80 + 20);
    EXPECT_AT_MOST(font.lineSpacing() * 2, tip->height());
    QVERIFY(QToolTip::text().contains("3 &lt; 4"));
    QToolTip::hideText();
  }

  void textsCanBeRead() {
    const theme::Tones& tones = theme::tones();
    for (const QColor& ground : {tones.panel, tones.field, tones.raised}) {
      EXPECT_AT_MOST(4.5, contrast(tones.text, ground));
    }
    for (const QColor& ground : {tones.panel, tones.field}) {
      EXPECT_AT_MOST(4.5, contrast(tones.dimText, ground));
      EXPECT_AT_MOST(4.5, contrast(tones.error, ground));
    }
    // On what is selected, and on the button that stands out.
    EXPECT_AT_MOST(4.5, contrast(QColor(0x10, 0x10, 0x10), tones.accent));
  }

  void controlsCanBeSeen() {
    const theme::Tones& tones = theme::tones();
    for (const QColor& ground : {tones.panel, tones.field, tones.raised}) {
      EXPECT_AT_MOST(3, contrast(tones.control, ground));
      EXPECT_AT_MOST(3, contrast(tones.accent, ground));
    }
  }

  void theWheelNeedsTheKeyboard() {
    QWidget window;
    auto* number = new QSpinBox(&window);
    auto* other = new QLineEdit(&window);
    other->move(0, 60);
    window.show();
    window.activateWindow();
    QVERIFY(QTest::qWaitForWindowActive(&window));
    const auto turnWheel = [number] {
      const QPointF place = number->rect().center();
      QWheelEvent event(place, number->mapToGlobal(place), {}, {0, 120}, Qt::NoButton,
                        Qt::NoModifier, Qt::NoScrollPhase, false);
      QApplication::sendEvent(number, &event);
    };
    other->setFocus();
    turnWheel();
    QCOMPARE(number->value(), 0);
    number->setFocus();
    turnWheel();
    QCOMPARE(number->value(), 1);
  }

  // As they are drawn.
  void grooveAndCheckBoxStandOut() {
    const QColor panel = theme::tones().panel;
    NeutralSlider slider{SliderScale()};
    slider.resize(200, 22);
    const QImage groove = slider.grab().toImage().copy(10, 0, 60, 22);
    EXPECT_AT_MOST(3, contrastAlong(groove, 11, panel));
    QCheckBox box("Link");
    box.resize(box.sizeHint());
    const QImage edge = box.grab().toImage().copy(0, 0, 12, box.height());
    EXPECT_AT_MOST(3, contrastAlong(edge, box.height() / 2, panel));
  }
};

CUTIS_TEST(ThemeTest)

}  // namespace
}  // namespace cutis

#include "theme_test.moc"
