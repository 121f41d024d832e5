#include "ui/docks/info_panel.h"

#include <QClipboard>
#include <QSignalSpy>
#include <QtTest>

#include "src/app/views/view_server.h"
#include "tests/support/scratch_folder.h"
#include "tests/support/test_registry.h"
#include "tests/ui/ui_test.h"
#include "ui/dialogs/export_controller.h"
#include "ui/docks/info_controller.h"
#include "ui/widgets/progress_strip.h"

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

  // What was said while it was being read is about the new document.
  void anotherDocumentClearsTheList() {
    const test::ScratchFolder folder;
    Engine engine(folder / "cache");
    JobRunner jobs;
    Document document(engine, jobs);
    ViewServer server(document, engine, jobs);
    ProgressStrip progress;
    QWidget window;
    auto* exports = new ExportController(document, engine, jobs, progress, &window);
    InfoPanel panel;
    InfoController controller(document, server, panel);
    connect(exports, &ExportController::noticed, &controller, &InfoController::add);
    document.open((folder / "missing.exr").string());
    QTRY_COMPARE(panel.count(), 1);
    QVERIFY(panel.item(0)->text().contains("missing.exr"));
    Q_EMIT exports->noticed("3 pixels were clipped.", false);
    QCOMPARE(panel.count(), 2);
    document.openSample();
    Q_EMIT document.noticed("Daylight was assumed.");
    QSignalSpy opened(&document, &Document::opened);
    QTRY_COMPARE_WITH_TIMEOUT(opened.count(), 1, 60000);
    jobs.stopAll();
    QCOMPARE(panel.count(), 1);
    QCOMPARE(panel.item(0)->text(), QString("Daylight was assumed."));
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
