#include "ui/edits/history_panel.h"

#include <QSignalSpy>
#include <QtTest>

#include "tests/support/test_registry.h"
#include "tests/ui/ui_test.h"

namespace cutis {
namespace {

class HistoryPanelTest : public test::UiTest {
  Q_OBJECT

 private slots:
  void theCurrentStepIsMarked() {
    HistoryPanel panel;
    panel.setSteps({"Opened", "Melanin × 1.4", "Carotene × 2"}, 1);
    QCOMPARE(panel.count(), 3);
    QCOMPARE(panel.currentRow(), 1);
    QVERIFY(panel.item(1)->text().contains("now"));
    QVERIFY(!panel.item(1)->font().italic());
    QVERIFY(panel.item(2)->font().italic());
  }

  void aClickChoosesAStep() {
    HistoryPanel panel;
    panel.resize(260, 200);
    panel.show();
    QSignalSpy chosen(&panel, &HistoryPanel::stepChosen);
    panel.setSteps({"Opened", "Melanin × 1.4", "Carotene × 2"}, 2);
    QCOMPARE(chosen.count(), 0);
    const auto click = [&](int row) {
      QTest::mouseClick(panel.viewport(), Qt::LeftButton, {},
                        panel.visualItemRect(panel.item(row)).center());
    };
    click(0);
    QVERIFY(chosen.count() >= 1);
    QCOMPARE(chosen.last()[0].toInt(), 0);
    panel.setSteps({"Opened", "Melanin × 1.4", "Carotene × 2"}, 0);
    chosen.clear();
    click(0);
    QCOMPARE(chosen.count(), 0);
    QTest::keyClick(&panel, Qt::Key_Down);
    QCOMPARE(chosen.last()[0].toInt(), 1);
  }
};

CUTIS_TEST(HistoryPanelTest)

}  // namespace
}  // namespace cutis

#include "history_panel_test.moc"
