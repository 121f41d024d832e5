#include "ui/docks/edit_panel.h"

#include <QCheckBox>
#include <QLineEdit>
#include <QPushButton>
#include <QSignalSpy>
#include <QtTest>

#include "tests/support/test_registry.h"
#include "tests/ui/ui_test.h"
#include "ui/widgets/neutral_slider.h"
#include "ui/widgets/panel_scroll.h"

namespace cutis {
namespace {

NeutralSlider* sliderNamed(EditPanel& panel, const QString& name) {
  for (NeutralSlider* slider : panel.findChildren<NeutralSlider*>()) {
    if (slider->accessibleName() == name) return slider;
  }
  return nullptr;
}

class EditPanelTest : public test::UiTest {
  Q_OBJECT

 private slots:
  void namesEveryParameterOnce() {
    EditPanel panel;
    QSignalSpy changed(&panel, &EditPanel::factorChanged);
    const std::pair<const char*, Parameter> names[] = {
        {"Melanin", kMelanin}, {"Melanin blend", kMelaninBlend}, {"Carotene", kCarotene}};
    for (const auto& [name, parameter] : names) {
      NeutralSlider* slider = sliderNamed(panel, name);
      QVERIFY2(slider, name);
      QTest::keyClick(slider, Qt::Key_Right);
      QCOMPARE(changed.takeLast()[0].toInt(), static_cast<int>(parameter));
    }
  }

  void linkedHaemoglobinsMoveTogetherAndEndOnce() {
    EditPanel panel;
    QSignalSpy changed(&panel, &EditPanel::factorChanged);
    QTest::keyClick(sliderNamed(panel, "Epidermal haemoglobin"), Qt::Key_Right);
    QCOMPARE(changed.count(), 2);
    QCOMPARE(changed[0][0].toInt(), static_cast<int>(kHaemoglobinDermal));
    QCOMPARE(changed[0][2].toBool(), true);
    QCOMPARE(changed[1][0].toInt(), static_cast<int>(kHaemoglobinEpidermal));
    QCOMPARE(changed[1][2].toBool(), false);
    QCOMPARE(panel.factors()[kHaemoglobinDermal], panel.factors()[kHaemoglobinEpidermal]);
  }

  void unlinkedOnesMoveAlone() {
    EditPanel panel;
    panel.findChild<QCheckBox*>()->setChecked(false);
    QTest::keyClick(sliderNamed(panel, "Dermal haemoglobin"), Qt::Key_Right);
    QCOMPARE(panel.factors()[kHaemoglobinEpidermal], 1.0);
  }

  void factorsAreSetSilently() {
    EditPanel panel;
    QSignalSpy changed(&panel, &EditPanel::factorChanged);
    panel.setFactors({1.5, 0.5, 1.2, 1.3, 2});
    QCOMPARE(changed.count(), 0);
    QCOMPARE(panel.factors()[kHaemoglobinEpidermal], 1.3);
    QCOMPARE(panel.factors()[kCarotene], 2.0);
    QVERIFY(!panel.findChild<QCheckBox*>()->isChecked());
  }

  // From slider to field, from row to row, and then the foot.
  void theKeyboardFollowsTheEye() {
    EditPanel panel;
    panel.setFactors({2, 1, 1, 1, 1});
    panel.resize(280, 400);
    panel.show();
    panel.activateWindow();
    QVERIFY(QTest::qWaitForWindowActive(&panel));
    QPoint last(-1, -1);
    QSet<QWidget*> reached;
    sliderNamed(panel, "Melanin")->setFocus();
    for (QWidget* at = QApplication::focusWidget(); !reached.contains(at);
         at = QApplication::focusWidget()) {
      reached << at;
      const QPoint place = at->mapTo(&panel, at->rect().center());
      QVERIFY2(place.y() > last.y() + 4 || place.x() > last.x(), qPrintable(at->accessibleName()));
      last = place;
      QTest::keyClick(at, Qt::Key_Tab);
    }
    // Five sliders with their fields, the link and at least the way back.
    QVERIFY(reached.size() >= 12);
  }

  // In a dock as well, whose scroll area takes the panel in.
  void theKeyboardGoesOnToTheFoot() {
    auto* panel = new EditPanel;
    PanelScroll scroll(panel);
    scroll.show();
    scroll.activateWindow();
    QVERIFY(QTest::qWaitForWindowActive(&scroll));
    auto* field =
        sliderNamed(*panel, "Epidermal haemoglobin")->parentWidget()->findChild<QLineEdit*>();
    field->setFocus();
    QTest::keyClick(field, Qt::Key_Tab);
    QCOMPARE(QApplication::focusWidget(), panel->findChild<QCheckBox*>());
  }

  void resetForgetsWhatWasRefused() {
    EditPanel panel;
    panel.show();
    panel.activateWindow();
    QVERIFY(QTest::qWaitForWindowActive(&panel));
    auto* field = sliderNamed(panel, "Melanin")->parentWidget()->findChild<QLineEdit*>();
    field->setFocus();
    field->selectAll();
    QTest::keyClicks(field, "9");
    QTest::keyClick(field, Qt::Key_Return);
    QCOMPARE(field->text(), QString("9"));
    QPushButton* reset = nullptr;
    for (QPushButton* found : panel.findChildren<QPushButton*>()) {
      if (found->text() == "Reset") reset = found;
    }
    QVERIFY(reset->isEnabled());
    QTest::mouseClick(reset, Qt::LeftButton);
    QVERIFY(field->text() != "9");
    QVERIFY(!reset->isEnabled());
    QVERIFY2(QApplication::focusWidget() != sliderNamed(panel, "Melanin"),
             "the panel stays where it is");
  }

  void whatRestsSaysWhy() {
    EditPanel panel;
    panel.setResting("There is no estimate.");
    QVERIFY(!sliderNamed(panel, "Melanin")->isEnabled());
    QCOMPARE(sliderNamed(panel, "Melanin")->parentWidget()->toolTip(),
             QString("There is no estimate."));
  }

  void resetIsOfferedWhereThereIsSomethingToReset() {
    EditPanel panel;
    QSignalSpy reset(&panel, &EditPanel::resetWanted);
    QPushButton* button = nullptr;
    for (QPushButton* found : panel.findChildren<QPushButton*>()) {
      if (found->text() == "Reset") button = found;
    }
    QVERIFY(!button->isEnabled());
    panel.setFactors({2, 1, 1, 1, 1});
    QTest::mouseClick(button, Qt::LeftButton);
    QCOMPARE(reset.count(), 1);
  }
};

CUTIS_TEST(EditPanelTest)

}  // namespace
}  // namespace cutis

#include "edit_panel_test.moc"
