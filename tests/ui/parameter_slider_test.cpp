#include "ui/widgets/parameter_slider.h"

#include <cmath>
#include <memory>

#include <QClipboard>
#include <QLabel>
#include <QMenu>
#include <QShortcut>
#include <QSignalSpy>
#include <QtTest>

#include "tests/support/expect.h"
#include "tests/support/test_registry.h"
#include "tests/ui/ui_test.h"
#include "ui/widgets/factor_field.h"
#include "ui/widgets/factor_text.h"
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
    QCOMPARE(field_->text(), shown(1, 2));
    QCOMPARE(slider_->accessibleName(), QString("Melanin"));
    QVERIFY(!field_->accessibleName().isEmpty());
  }

  void theNumberStandsOnTheSlidersRow() {
    QVERIFY(std::abs(slider_->geometry().center().y() - field_->geometry().center().y()) <= 1);
    QVERIFY(field_->x() > slider_->geometry().right());
  }

  void settingIsSilentAndClamps() {
    widget_->setValue(1.75);
    QCOMPARE(field_->text(), shown(1.75, 2));
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
    QCOMPARE(steps_->count(), 0);
    QTest::mouseRelease(slider_, Qt::LeftButton, {}, middle + QPoint(50, 0));
    QCOMPARE(changed_->last()[1].toBool(), false);
    QVERIFY(widget_->value() > 1.2);
    EXPECT_NEAR(changed_->last()[0].toDouble(), widget_->value(), 0);
    int final = 0;
    for (const auto& call : *changed_)
      final += call[1].toBool() ? 0 : 1;
    QCOMPARE(final, 1);
    QCOMPARE(steps_->count(), 1);
  }

  // On the handle and beside it.
  void aClickWithoutMovementIsNothing() {
    for (const int x : {0, 30, -40}) {
      const QPoint place = slider_->rect().center() + QPoint(x, 0);
      QTest::mousePress(slider_, Qt::LeftButton, {}, place);
      QTest::mouseMove(slider_, place + QPoint(0, 4));
      QTest::mouseRelease(slider_, Qt::LeftButton, {}, place);
    }
    EXPECT_NEAR(widget_->value(), 1, 0);
    QCOMPARE(changed_->count(), 0);
    QCOMPARE(steps_->count(), 0);
  }

  // An undo while the mouse holds the handle: what comes after it would make the undo undone.
  void anotherNumberEndsTheDrag() {
    const QPoint middle = slider_->rect().center();
    QTest::mousePress(slider_, Qt::LeftButton, {}, middle);
    QTest::mouseMove(slider_, middle + QPoint(20, 0));
    const auto before = changed_->count();
    widget_->setValue(1);
    QTest::mouseMove(slider_, middle + QPoint(40, 0));
    QTest::mouseRelease(slider_, Qt::LeftButton, {}, middle + QPoint(40, 0));
    QCOMPARE(changed_->count(), before);
    EXPECT_NEAR(widget_->value(), 1, 0);
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

  void doubleClickOnTheNeutralValueIsNothing() {
    QTest::mouseDClick(slider_, Qt::LeftButton, {}, slider_->rect().center());
    QCOMPARE(changed_->count(), 0);
  }

  void keysStep() {
    QTest::keyClick(slider_, Qt::Key_Right);
    EXPECT_NEAR(widget_->value(), 1.05, 1e-12);
    QTest::keyClick(slider_, Qt::Key_Left, Qt::ShiftModifier);
    EXPECT_NEAR(widget_->value(), 1.045, 1e-12);
    QTest::keyClick(slider_, Qt::Key_End);
    EXPECT_NEAR(widget_->value(), 3, 0);
    QTest::keyClick(slider_, Qt::Key_End);
    QTest::keyClick(slider_, Qt::Key_Delete);
    EXPECT_NEAR(widget_->value(), 1, 0);
    QCOMPARE(changed_->count(), 4);
    for (const auto& call : *changed_)
      QCOMPARE(call[1].toBool(), false);
  }

  void aBurstOfKeysIsOneStep() {
    for (int i = 0; i < 5; ++i)
      QTest::keyClick(slider_, Qt::Key_Right);
    QCOMPARE(changed_->count(), 5);
    QCOMPARE(steps_->count(), 0);
    QTRY_COMPARE(steps_->count(), 1);
    QTest::keyClick(slider_, Qt::Key_Right);
    QTRY_COMPARE(steps_->count(), 2);
  }

  // Without waiting for the pause.
  void whateverElseIsDoneEndsABurst() {
    slider_->setFocus();
    QTest::keyClick(slider_, Qt::Key_Right);
    field_->setFocus();
    QCOMPARE(steps_->count(), 1);
    QTest::keyClick(field_, Qt::Key_Up);
    EXPECT_NEAR(widget_->value(), 1.1, 1e-12);
    const QPoint middle = slider_->rect().center();
    QTest::mousePress(slider_, Qt::LeftButton, {}, middle);
    QTest::mouseMove(slider_, middle + QPoint(20, 0));
    QCOMPARE(steps_->count(), 2);
    QTest::mouseRelease(slider_, Qt::LeftButton, {}, middle + QPoint(20, 0));
    QCOMPARE(steps_->count(), 3);
  }

  void theWheelNeedsTheKeyboard() {
    field_->setFocus();
    QVERIFY(!turnWheel(1));
    QCOMPARE(changed_->count(), 0);
    slider_->setFocus();
    QVERIFY(turnWheel(1));
    QVERIFY(turnWheel(1));
    EXPECT_NEAR(widget_->value(), 1.1, 1e-12);
    QTRY_COMPARE(steps_->count(), 1);
  }

  void typedNumbersAreOneChange() {
    type("1.25");
    QCOMPARE(changed_->count(), 0);
    QTest::keyClick(field_, Qt::Key_Return);
    QCOMPARE(changed_->count(), 1);
    EXPECT_NEAR(widget_->value(), 1.25, 0);
    QCOMPARE(changed_->last()[1].toBool(), false);
    QCOMPARE(steps_->count(), 1);
    QCOMPARE(field_->text(), shown(1.25, 2));
  }

  void numbersAreWrittenInMoreThanOneWay_data() {
    QTest::addColumn<QString>("text");
    QTest::addColumn<double>("factor");
    const std::pair<const char*, double> ways[] = {
        {"1,5", 1.5},      {"1.5", 1.5},  {"×1.5", 1.5},     {"x 1,5", 1.5},
        {"150 %", 1.5},    {"150%", 1.5}, {" 0 ", 0},        {"3", 3},
        {"37,5 %", 0.375}, {"×200 %", 2}, {"1.2345", 1.2345}};
    for (const auto& [text, factor] : ways)
      QTest::newRow(text) << QString::fromUtf8(text) << factor;
  }
  void numbersAreWrittenInMoreThanOneWay() {
    QFETCH(QString, text);
    QFETCH(double, factor);
    const ReadFactor read = readFactor(text, {});
    QVERIFY2(read.objection.isEmpty(), qPrintable(read.objection));
    EXPECT_NEAR(read.factor, factor, 1e-12);
  }

  void wrongNumbersAreReportedAndKept_data() {
    QTest::addColumn<QString>("text");
    for (const char* text : {"5", "-1", "abc", "", "1.000,5", "301 %", "1,5,5", "nan", "inf", "1e"})
      QTest::newRow(text) << QString(text);
  }
  void wrongNumbersAreReportedAndKept() {
    QFETCH(QString, text);
    type(text);
    QTest::keyClick(field_, Qt::Key_Return);
    slider_->setFocus();
    QCOMPARE(field_->text(), text);
    QVERIFY(field_->property("refused").toBool());
    const QLabel* message = messageOf(*widget_);
    QVERIFY(message != nullptr && message->text().contains("0 to 3"));
    QCOMPARE(changed_->count(), 0);
    EXPECT_NEAR(widget_->value(), 1, 0);
    // Shown anew with the number that holds, as after an edit elsewhere.
    widget_->setValue(1);
    QCOMPARE(field_->text(), text);
    // Corrected.
    field_->setFocus();
    type("2");
    QVERIFY(messageOf(*widget_) == nullptr);
    QTest::keyClick(field_, Qt::Key_Return);
    EXPECT_NEAR(widget_->value(), 2, 0);
    QVERIFY(!field_->property("refused").toBool());
  }

  // So that what is typed after a click replaces the number.
  void aClickSelectsTheNumber() {
    slider_->setFocus();
    QTest::mouseClick(field_, Qt::LeftButton, {}, field_->rect().center());
    QTest::keyClicks(field_, "1,5");
    QTest::keyClick(field_, Qt::Key_Return);
    EXPECT_NEAR(widget_->value(), 1.5, 0);
  }

  void escapeBringsTheNumberBack() {
    type("abc");
    QTest::keyClick(field_, Qt::Key_Return);
    QTest::keyClick(field_, Qt::Key_Escape);
    QCOMPARE(field_->text(), shown(1, 2));
    QVERIFY(messageOf(*widget_) == nullptr);
  }

  // Wherever the keyboard is by then: the sentence says so.
  void escapeFromElsewhereBringsTheNumberBack() {
    type("9");
    QTest::keyClick(field_, Qt::Key_Return);
    slider_->setFocus();
    QVERIFY(messageOf(*widget_) != nullptr);
    QTest::keyClick(slider_, Qt::Key_Escape);
    QCOMPARE(field_->text(), shown(1, 2));
    QVERIFY(messageOf(*widget_) == nullptr);
  }

  void aDragEndsWhatWasRefused() {
    type("9");
    QTest::keyClick(field_, Qt::Key_Return);
    QTest::keyClick(slider_, Qt::Key_Right);
    QVERIFY(messageOf(*widget_) == nullptr);
    QCOMPARE(field_->text(), shown(1.05, 2));
  }

  // Undo belongs to the text while it is being typed, then to the document.
  void undoOfWhatWasTakenIsTheDocuments() {
    int undone = 0;
    QShortcut undo(QKeySequence::Undo, widget_.get());
    connect(&undo, &QShortcut::activated, this, [&] { ++undone; });
    type("1.5");
    QTest::keyClick(field_, Qt::Key_Z, Qt::ControlModifier);
    QCOMPARE(undone, 0);
    QVERIFY(field_->text() != "1.5");
    type("1.5");
    QTest::keyClick(field_, Qt::Key_Return);
    QTest::keyClick(field_, Qt::Key_Z, Qt::ControlModifier);
    QCOMPARE(undone, 1);
    QCOMPARE(field_->text(), shown(1.5, 2));
  }

  void whatRestsSaysWhy() {
    widget_->setResting("There is no estimate yet.");
    QVERIFY(!slider_->isEnabled() && !field_->isEnabled());
    QCOMPARE(widget_->toolTip(), QString("There is no estimate yet."));
    QCOMPARE(field_->toolTip(), QString("There is no estimate yet."));
    widget_->setResting({});
    QVERIFY(slider_->isEnabled());
    QCOMPARE(widget_->toolTip(), QString("Tans"));
    QVERIFY(field_->toolTip().contains("0 to 3"));
  }

  void theRightButtonResetsCopiesAndEnters() {
    widget_->setValue(1.5);
    chooseFromMenu(1);
    QCOMPARE(QGuiApplication::clipboard()->text(), shown(1.5, 2).mid(1));
    chooseFromMenu(0);
    EXPECT_NEAR(widget_->value(), 1, 0);
    QCOMPARE(steps_->count(), 1);
    chooseFromMenu(2);
    QTRY_VERIFY(field_->hasFocus());
  }

 private:
  void tearDown() override {
    changed_.reset();
    steps_.reset();
    widget_.reset();
  }

  void setUp() override {
    widget_ = std::make_unique<ParameterSlider>("Melanin", "Tans");
    widget_->resize(240, 60);
    widget_->show();
    widget_->activateWindow();
    QVERIFY(QTest::qWaitForWindowActive(widget_.get()));
    slider_ = widget_->findChild<NeutralSlider*>();
    field_ = widget_->findChild<FactorField*>();
    changed_ = std::make_unique<QSignalSpy>(widget_.get(), &ParameterSlider::valueChanged);
    steps_ = std::make_unique<QSignalSpy>(widget_.get(), &ParameterSlider::stepEnded);
  }

  static QString shown(double factor, int decimals) {
    return QString("×") + QLocale().toString(factor, 'f', decimals);
  }
  static const QLabel* messageOf(const ParameterSlider& widget) {
    for (const QLabel* label : widget.findChildren<QLabel*>()) {
      if (label->isVisible() && label->wordWrap()) return label;
    }
    return nullptr;
  }
  void type(const QString& text) {
    field_->setFocus();
    field_->selectAll();
    QTest::keyClick(field_, Qt::Key_Delete);
    QTest::keyClicks(field_, text);
  }
  // Whether the slider has taken it.
  bool turnWheel(int notches) {
    const QPointF place = slider_->rect().center();
    QWheelEvent event(place, slider_->mapToGlobal(place), {}, {0, 120 * notches}, Qt::NoButton,
                      Qt::NoModifier, Qt::NoScrollPhase, false);
    QApplication::sendEvent(slider_, &event);
    return event.isAccepted();
  }
  void chooseFromMenu(int row) {
    QContextMenuEvent event(QContextMenuEvent::Mouse, {5, 5}, slider_->mapToGlobal(QPoint(5, 5)));
    QApplication::sendEvent(slider_, &event);
    auto* menu = qobject_cast<QMenu*>(QApplication::activePopupWidget());
    QVERIFY(menu != nullptr);
    QTest::mouseClick(menu, Qt::LeftButton, {},
                      menu->actionGeometry(menu->actions()[row]).center());
    QTRY_VERIFY(QApplication::activePopupWidget() == nullptr);
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
  std::unique_ptr<QSignalSpy> steps_;
  NeutralSlider* slider_ = nullptr;
  FactorField* field_ = nullptr;
};

CUTIS_TEST(ParameterSliderTest)

}  // namespace
}  // namespace cutis

#include "parameter_slider_test.moc"
