#include "ui/docks/light_panel.h"

#include <QComboBox>
#include <QSignalSpy>
#include <QToolButton>
#include <QtTest>

#include "tests/support/test_registry.h"
#include "tests/ui/ui_test.h"
#include "ui/docks/light_catalogue.h"

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
    const LightChoice choice = {"A", "cie1964", LightChoice::Kind::nearInfrared,
                                ChromaticAdaptation::cat16};
    panel.setChoice(choice);
    QVERIFY(panel.choice() == choice);
    panel.setLights(kLights);
    QVERIFY(panel.choice() == choice);
    panel.setChoice({"no such light", "cie1931"});
    QCOMPARE(panel.choice().light, QString("A"));
    QCOMPARE(changed.count(), 0);
  }

  void eyesAdaptAndCamerasDoNot() {
    LightPanel panel;
    panel.setLights(lightGroups());
    panel.setObservers(observerChoices());
    QComboBox* box = boxNamed(panel, "Chromatic adaptation");
    QVERIFY(box->isEnabled());
    QSignalSpy changed(&panel, &LightPanel::changed);
    QTest::keyClick(box, Qt::Key_Down);
    QCOMPARE(changed.count(), 1);
    QVERIFY(panel.choice().adaptation == ChromaticAdaptation::bradford);
    LightChoice camera = panel.choice();
    camera.observer = "Nikon_D850";
    panel.setChoice(camera);
    QVERIFY(!box->isEnabled());
    QVERIFY(box->toolTip().contains("camera"));
  }

  // Nobody reads the names of files.
  void everyLightAndObserverHasANameForPeople() {
    QStringList titles;
    for (const LightGroup& group : lightGroups()) {
      for (const QString& name : group.names)
        titles << titleOf(name);
    }
    for (const QString& name : observerChoices())
      titles << titleOf(name);
    for (const QString& title : titles)
      QVERIFY2(title.size() > 3 && !title.contains('_'), qPrintable(title));
    QCOMPARE(titles.removeDuplicates(), 0);
    QCOMPARE(titleOf("cie1931"), QString("CIE 1931 2°"));
    QCOMPARE(titleOf("A"), QString("Tungsten lamp (A)"));
    QCOMPARE(titleOf("Canon_EOS_5D_Mark_IV"), QString("Canon EOS 5D Mark IV"));
  }

  void bandsKeepTheLight() {
    LightPanel panel;
    panel.setLights(kLights);
    panel.setChoice({"D65", ""});
    QSignalSpy changed(&panel, &LightPanel::changed);
    for (QToolButton* button : panel.findChildren<QToolButton*>()) {
      if (button->text() == "UV") QTest::mouseClick(button, Qt::LeftButton);
    }
    QCOMPARE(changed.count(), 1);
    QVERIFY(panel.choice().kind == LightChoice::Kind::ultraviolet);
    QCOMPARE(panel.choice().light, QString("D65"));
  }

 private:
  static QComboBox* boxNamed(const LightPanel& panel, const QString& name) {
    for (QComboBox* box : panel.findChildren<QComboBox*>()) {
      if (box->accessibleName() == name) return box;
    }
    return nullptr;
  }
};

CUTIS_TEST(LightPanelTest)

}  // namespace
}  // namespace cutis

#include "light_panel_test.moc"
