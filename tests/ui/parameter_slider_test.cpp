#include "ui/widgets/parameter_slider.h"

#include <memory>

#include <QDoubleSpinBox>
#include <QSignalSpy>
#include <QtTest>

#include "tests/support/expect.h"
#include "tests/support/test_registry.h"
#include "tests/ui/ui_test.h"
#include "ui/widgets/neutral_slider.h"

namespace cutis {
namespace {

class ParameterSliderTest : public test::UiTest {
  Q_OBJECT

 private slots:
  void theScaleHasItsNeutralInTheMiddle() {
    const SliderScale scale;
    EXPECT_NEAR(scale.valueAt(0), 0, 0);
    EXPECT_NEAR(scale.valueAt(0.5), 1, 1e-12);
    EXPECT_NEAR(scale.valueAt(1), 3, 1e-12);
    for (double value = 0; value <= 3; value += 0.125) {
      EXPECT_NEAR(scale.valueAt(scale.placeOf(value)), value, 1e-12);
    }
    const SliderScale even = {-1, 0, 1};
    EXPECT_NEAR(even.valueAt(0.75), 0.5, 1e-12);
  }

  void startsNeutral() {
    EXPECT_NEAR(widget_->value(), 1, 0);
    EXPECT_NEAR(field_->value(), 1, 0);
    QCOMPARE(slider_->accessibleName(), QString("Melanin"));
    QVERIFY(!field_->accessibleName().isEmpty());
  }

  void settingIsSilentAndClamps() {
    widget_->setValue(1.75);
    EXPECT_NEAR(field_->value(), 1.75, 0);
    widget_->setValue(99);
    EXPECT_NEAR(widget_->value(), 3, 0);
    QCOMPARE(changed_->count(), 0);
  }

  void aDragEndsOnce() {
    const QPoint middle = slider_->rect().center();
    QTest::mousePress(slider_, Qt::LeftButton, {}, middle);
    QCOMPARE(changed_->count(), 0);
    for (int x = 5; x <= 50; x += 5)
      QTest::mouseMove(slider_, middle + QPoint(x, 0));
    QVERIFY(changed_->count() >= 2);
    for (const auto& call : *changed_)
      QCOMPARE(call[1].toBool(), true);
    QTest::mouseRelease(slider_, Qt::LeftButton, {}, middle + QPoint(50, 0));
    QCOMPARE(changed_->last()[1].toBool(), false);
    QVERIFY(widget_->value() > 1.2);
    EXPECT_NEAR(changed_->last()[0].toDouble(), widget_->value(), 0);
    int final = 0;
    for (const auto& call : *changed_)
      final += call[1].toBool() ? 0 : 1;
    QCOMPARE(final, 1);
  }

  void shiftIsTenTimesFiner() {
    const double coarse = dragged(Qt::NoModifier);
    widget_->setValue(1);
    const double fine = dragged(Qt::ShiftModifier);
    EXPECT_NEAR((fine - 1) / (coarse - 1), 0.1, 0.04);
  }

  void doubleClickIsNeutral() {
    widget_->setValue(2);
    QTest::mouseDClick(slider_, Qt::LeftButton, {}, slider_->rect().center() + QPoint(30, 0));
    EXPECT_NEAR(widget_->value(), 1, 0);
    QCOMPARE(changed_->last()[1].toBool(), false);
  }

  void keysStep() {
    QTest::keyClick(slider_, Qt::Key_Right);
    EXPECT_NEAR(widget_->value(), 1.05, 1e-12);
    QTest::keyClick(slider_, Qt::Key_Left, Qt::ShiftModifier);
    EXPECT_NEAR(widget_->value(), 1.045, 1e-12);
    QTest::keyClick(slider_, Qt::Key_End);
    EXPECT_NEAR(widget_->value(), 3, 0);
    QTest::keyClick(slider_, Qt::Key_Delete);
    EXPECT_NEAR(widget_->value(), 1, 0);
    QCOMPARE(changed_->count(), 4);
    for (const auto& call : *changed_)
      QCOMPARE(call[1].toBool(), false);
  }

  void typedNumbersAreOneChange() {
    field_->setFocus();
    field_->selectAll();
    QTest::keyClicks(field_, QLocale().toString(1.25, 'f', 2));
    QCOMPARE(changed_->count(), 0);
    QTest::keyClick(field_, Qt::Key_Return);
    QCOMPARE(changed_->count(), 1);
    EXPECT_NEAR(widget_->value(), 1.25, 0);
    QCOMPARE(changed_->last()[1].toBool(), false);
  }

 private:
  void tearDown() override {
    changed_.reset();
    widget_.reset();
  }

  void setUp() override {
    widget_ = std::make_unique<ParameterSlider>("Melanin", "Tans");
    widget_->resize(240, 60);
    widget_->show();
    QVERIFY(QTest::qWaitForWindowExposed(widget_.get()));
    slider_ = widget_->findChild<NeutralSlider*>();
    field_ = widget_->findChild<QDoubleSpinBox*>();
    changed_ = std::make_unique<QSignalSpy>(widget_.get(), &ParameterSlider::valueChanged);
  }

  double dragged(Qt::KeyboardModifiers modifiers) {
    const QPoint middle = slider_->rect().center();
    QTest::mousePress(slider_, Qt::LeftButton, modifiers, middle);
    QMouseEvent move(QEvent::MouseMove, QPointF(middle + QPoint(40, 0)),
                     slider_->mapToGlobal(QPointF(middle + QPoint(40, 0))), Qt::NoButton,
                     Qt::LeftButton, modifiers);
    QApplication::sendEvent(slider_, &move);
    QTest::mouseRelease(slider_, Qt::LeftButton, modifiers, middle + QPoint(40, 0));
    return widget_->value();
  }

  std::unique_ptr<ParameterSlider> widget_;
  std::unique_ptr<QSignalSpy> changed_;
  NeutralSlider* slider_ = nullptr;
  QDoubleSpinBox* field_ = nullptr;
};

CUTIS_TEST(ParameterSliderTest)

}  // namespace
}  // namespace cutis

#include "parameter_slider_test.moc"
