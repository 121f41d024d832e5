#include "ui/docks/edit_panel.h"

#include <QCheckBox>
#include <QPushButton>
#include <QSignalSpy>
#include <QtTest>

#include "tests/support/test_registry.h"
#include "tests/ui/ui_test.h"
#include "ui/widgets/neutral_slider.h"

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
    QVERIFY(!panel.haemoglobinsLinked());
  }

  void resetIsOfferedWhereThereIsSomethingToReset() {
    EditPanel panel;
    QSignalSpy reset(&panel, &EditPanel::resetWanted);
    auto* button = panel.findChild<QPushButton*>();
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
