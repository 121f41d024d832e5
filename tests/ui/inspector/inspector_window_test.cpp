// The inspector over the embedded sample, pointed at with the mouse.

#include <memory>

#include <QApplication>
#include <QClipboard>
#include <QtTest>

#include "src/app/document/place_spectra.h"
#include "tests/support/expect.h"
#include "tests/support/scratch_folder.h"
#include "tests/support/test_registry.h"
#include "tests/ui/ui_test.h"
#include "tests/ui/window_steps.h"
#include "ui/commands/command_registry.h"
#include "ui/dialogs/open_controller.h"
#include "ui/docks/edit_controller.h"
#include "ui/documents/document_page.h"
#include "ui/documents/document_tabs.h"
#include "ui/inspector/inspector_controller.h"
#include "ui/inspector/inspector_panel.h"
#include "ui/view/viewport.h"
#include "ui/window/main_window.h"

namespace cutis {
namespace {

constexpr int kInspectorPatienceMs = 120000;
constexpr QPoint kCheek(300, 500);

class InspectorWindowTest : public test::UiTest {
  Q_OBJECT

 private slots:
  void initTestCase() { test::keepSettingsIn(folder_.path()); }

  void nothingIsLookedUpWhileItIsHidden() {
    point(kCheek);
    QCOMPARE(page().inspector().lookups(), 0);
    showDock();
    QCOMPARE(page().inspector().lookups(), 1);
  }

  void saysWhatTheDocumentKnows() {
    showDock();
    point(kCheek);
    const auto spectra = window_->document().spectraAt(kCheek.x(), kCheek.y());
    QVERIFY(spectra && spectra->parameterDeviation);
    const double melanin = 100 * spectra->originalParameters[kMelanin];
    const InspectorRow row = rowOf("Melanin");
    QVERIFY2(row.value.startsWith(QString::number(melanin, 'g', melanin < 10 ? 2 : 3) + " %"),
             qPrintable(row.value));
    QVERIFY(row.value.contains("±") && row.edited.isEmpty());
    QCOMPARE(rowOf("Pixel").value, QString("300, 500"));
    QVERIFY(rowOf("ITA").value.endsWith("°"));
    QVERIFY(rowOf("Model to photograph").value.toDouble() < 3.0);
  }

  void followsEditsAndIsCopied() {
    showDock();
    point(kCheek);
    window_->edits().setFactor(kMelanin, 2.0, false);
    waitUntilIdle();
    QVERIFY(!rowOf("Melanin").edited.isEmpty());
    QVERIFY(!rowOf("ITA").edited.isEmpty());
    panel()->setFocus();
    QTest::keyClick(panel(), Qt::Key_C, Qt::ControlModifier);
    QVERIFY(QApplication::clipboard()->text().contains("Melanin\t"));
  }

  // Where nothing was fitted the picture's own numbers stand.
  void whereThereIsNoSkin() {
    showDock();
    point(QPoint(3, 3));
    QCOMPARE(rowOf("Melanin").value, QString("–"));
    QVERIFY(!rowOf("Linear Rec.709").value.isEmpty());
  }

 private:
  DocumentPage& page() { return window_->findChild<DocumentTabs*>()->current(); }
  InspectorPanel* panel() { return window_->findChild<InspectorPanel*>(); }
  void showDock() {
    QCOMPARE(window_->commands().run("dock.inspector"), QString());
    QTRY_VERIFY(panel()->isVisible());
    waitUntilIdle();
  }
  void point(const QPoint& pixel) {
    Viewport& viewport = window_->viewport();
    const QPointF place = viewport.toWidget(QPointF(pixel) + QPointF(0.5, 0.5));
    QTest::mouseMove(&viewport, place.toPoint());
    Q_EMIT viewport.cursorMoved(pixel.x(), pixel.y());
    waitUntilIdle();
  }
  InspectorRow rowOf(const QString& name) {
    for (const InspectorRow& row : panel()->rows()) {
      if (row.name == name) return row;
    }
    return {};
  }
  void waitUntilIdle() {
    QTest::qWait(10);
    QTRY_VERIFY_WITH_TIMEOUT(window_->isIdle(), kInspectorPatienceMs);
  }
  void tearDown() override { window_.reset(); }
  void setUp() override {
    window_ = std::make_unique<MainWindow>(std::make_unique<Engine>(folder_ / "cache"));
    window_->resize(1440, 900);
    window_->show();
    window_->opener().openSample();
    waitUntilIdle();
  }

  test::ScratchFolder folder_;
  std::unique_ptr<MainWindow> window_;
};

CUTIS_TEST(InspectorWindowTest)

}  // namespace
}  // namespace cutis

#include "inspector_window_test.moc"
