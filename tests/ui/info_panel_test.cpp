#include "ui/docks/info_panel.h"

#include <QClipboard>
#include <QtTest>

#include "tests/support/test_registry.h"
#include "tests/ui/ui_test.h"

namespace cutis {
namespace {

class InfoPanelTest : public test::UiTest {
  Q_OBJECT

 private slots:
  void theNewestStandsFirstAndOnce() {
    InfoPanel panel;
    panel.add("sRGB was assumed.", false);
    panel.add("3 pixels were clipped.", false);
    panel.add("sRGB was assumed.", false);
    QCOMPARE(panel.count(), 2);
    QCOMPARE(panel.item(0)->text(), QString("sRGB was assumed."));
  }

  void sentencesAreCopied() {
    InfoPanel panel;
    panel.add("First.", false);
    panel.add("Second.", true);
    QTest::keySequence(&panel, QKeySequence::Copy);
    QCOMPARE(QGuiApplication::clipboard()->text(), QString("Second.\nFirst."));
    panel.item(1)->setSelected(true);
    QTest::keySequence(&panel, QKeySequence::Copy);
    QCOMPARE(QGuiApplication::clipboard()->text(), QString("First."));
  }

  void theOldestGo() {
    InfoPanel panel;
    for (const char* sentence : {"One.", "Two.", "Three."})
      panel.add(sentence, false);
    panel.keepNewest(1);
    QCOMPARE(panel.count(), 1);
    QCOMPARE(panel.item(0)->text(), QString("Three."));
  }
};

CUTIS_TEST(InfoPanelTest)

}  // namespace
}  // namespace cutis

#include "info_panel_test.moc"
