#include "ui/docks/light_panel.h"

#include <QComboBox>
#include <QSignalSpy>
#include <QToolButton>
#include <QtTest>

#include "tests/support/test_registry.h"
#include "tests/ui/ui_test.h"

namespace cutis {
namespace {

const QVector<LightGroup> kLights = {{"Daylight", {"D50", "D65"}}, {"Tungsten", {"A"}}};

class LightPanelTest : public test::UiTest {
  Q_OBJECT

 private slots:
  void titlesCannotBeChosen() {
    LightPanel panel;
    panel.setLights(kLights);
    panel.setObservers({"cie1931", "cie1964"});
    QCOMPARE(panel.choice().light, QString("D50"));
    QSignalSpy changed(&panel, &LightPanel::changed);
    auto* box = panel.findChildren<QComboBox*>().first();
    QTest::keyClick(box, Qt::Key_Down);
    QTest::keyClick(box, Qt::Key_Down);
    QCOMPARE(panel.choice().light, QString("A"));
    QCOMPARE(changed.count(), 2);
    QCOMPARE(changed.last()[0].value<LightChoice>().light, QString("A"));
  }

  void choicesAreSetSilently() {
    LightPanel panel;
    panel.setLights(kLights);
    panel.setObservers({"cie1931", "cie1964"});
    QSignalSpy changed(&panel, &LightPanel::changed);
    const LightChoice choice = {"A", "cie1964", LightChoice::Kind::nearInfrared};
    panel.setChoice(choice);
    QVERIFY(panel.choice() == choice);
    panel.setLights(kLights);
    QVERIFY(panel.choice() == choice);
    panel.setChoice({"no such light", "cie1931", LightChoice::Kind::colour});
    QCOMPARE(panel.choice().light, QString("A"));
    QCOMPARE(changed.count(), 0);
  }

  void bandsKeepTheLight() {
    LightPanel panel;
    panel.setLights(kLights);
    panel.setChoice({"D65", "", LightChoice::Kind::colour});
    QSignalSpy changed(&panel, &LightPanel::changed);
    for (QToolButton* button : panel.findChildren<QToolButton*>()) {
      if (button->text() == "UV") QTest::mouseClick(button, Qt::LeftButton);
    }
    QCOMPARE(changed.count(), 1);
    QVERIFY(panel.choice().kind == LightChoice::Kind::ultraviolet);
    QCOMPARE(panel.choice().light, QString("D65"));
  }
};

CUTIS_TEST(LightPanelTest)

}  // namespace
}  // namespace cutis

#include "light_panel_test.moc"
