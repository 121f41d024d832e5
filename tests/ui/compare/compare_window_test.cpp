// Two pictures of one place in one view, and the exposure of the view, on the embedded sample.

#include <memory>

#include <QApplication>
#include <QClipboard>
#include <QDoubleSpinBox>
#include <QtTest>

#include "tests/support/scratch_folder.h"
#include "tests/support/test_registry.h"
#include "tests/ui/ui_test.h"
#include "tests/ui/window_steps.h"
#include "ui/commands/command_registry.h"
#include "ui/compare/comparison_controller.h"
#include "ui/dialogs/open_controller.h"
#include "ui/docks/edit_controller.h"
#include "ui/documents/document_page.h"
#include "ui/documents/document_tabs.h"
#include "ui/view/adjustment_bar.h"
#include "ui/view/view_controller.h"
#include "ui/view/viewport.h"
#include "ui/window/main_window.h"

namespace cutis {
namespace {

constexpr int kComparePatienceMs = 120000;
// Of the picture's lower part, where neither names nor bars are.
constexpr double kRow = 0.7;

// A sample stands in until the mean of its pixels is made.
bool isClose(QRgb a, QRgb b) {
  constexpr int kMost = 3;
  return std::abs(qRed(a) - qRed(b)) <= kMost && std::abs(qGreen(a) - qGreen(b)) <= kMost &&
         std::abs(qBlue(a) - qBlue(b)) <= kMost;
}

class CompareWindowTest : public test::UiTest {
  Q_OBJECT

 private slots:
  void initTestCase() { test::keepSettingsIn(folder_.path()); }

  void theWipeShowsBothAndIsDragged() {
    const QImage original = shown(ViewKind::photograph);
    const QImage edited = shown(ViewKind::editedAlbedo);
    QVERIFY(!isClose(original.pixel(500, 400), edited.pixel(500, 400)));
    press(Qt::Key_W);
    QCOMPARE(view().splitMode(), SplitMode::wipe);
    const int line = static_cast<int>(view().width() * view().wipePosition());
    expectSides(edited, original, line);
    const QPoint grip(line, view().height() / 2);
    const QPoint to = grip + QPoint(120, 30);
    QTest::mousePress(&view(), Qt::LeftButton, {}, grip);
    QTest::mouseMove(&view(), to);
    QTest::mouseRelease(&view(), Qt::LeftButton, {}, to);
    expectSides(edited, original, to.x());
    press(Qt::Key_Left, Qt::ShiftModifier);
    expectSides(edited, original, to.x() - view().width() / 50);
    press(Qt::Key_W);
    QCOMPARE(view().splitMode(), SplitMode::none);
  }

  void sideBySideLooksAtOnePlace() {
    window_->views().show(ViewKind::editedAlbedo);
    press(Qt::Key_W, Qt::ShiftModifier);
    QCOMPARE(view().splitMode(), SplitMode::sideBySide);
    press(Qt::Key_1);
    waitUntilIdle();
    const int half = view().width() / 2;
    const QPointF left = view().toImage(QPointF(half / 2.0, 100));
    const QPointF right = view().toImage(QPointF(half + half / 2.0, 100));
    QVERIFY(std::abs(left.x() - right.x()) <= 1.0 && std::abs(left.y() - right.y()) <= 1.0);
    press(Qt::Key_W, Qt::ShiftModifier);
    QCOMPARE(view().splitMode(), SplitMode::none);
  }

  void aTapTurnsAndAHeldKeyTurnsBack() {
    const QImage original = shown(ViewKind::photograph);
    const QImage edited = shown(ViewKind::editedAlbedo);
    press(Qt::Key_T);
    expectSides(original, original, 0);
    press(Qt::Key_T);
    expectSides(edited, edited, 0);
    QTest::keyPress(&view(), Qt::Key_T);
    waitUntilIdle();
    expectSides(original, original, 0);
    QTest::qWait(500);
    QTest::keyRelease(&view(), Qt::Key_T);
    waitUntilIdle();
    expectSides(edited, edited, 0);
  }

  void theDifferenceHasABarOfItsOwn() {
    window_->views().show(ViewKind::editedAlbedo);
    press(Qt::Key_D);
    QVERIFY(view().colorBar() && view().colorBar()->name == "ΔE 2000");
    QVERIFY(view().colorBar()->range.maximum > 1.0);
    window_->views().show(ViewKind::melanin);
    waitUntilIdle();
    QCOMPARE(view().colorBar()->name, QString("Difference of Melanin"));
    press(Qt::Key_D);
    QCOMPARE(view().colorBar()->name, QString("Melanin"));
  }

  // From one way of comparing to another without an end between them.
  void theOtherPictureStays() {
    const QImage original = shown(ViewKind::photograph);
    const QImage edited = shown(ViewKind::editedAlbedo);
    press(Qt::Key_D);
    press(Qt::Key_W);
    expectSides(edited, original, static_cast<int>(view().width() * view().wipePosition()));
    press(Qt::Key_T);
    expectSides(original, original, 0);
  }

  // Two edits against each other: the second adds to the first.
  void keptEditsAreComparedWith() {
    QVERIFY(!window_->commands().action("compare.kept")->isEnabled());
    const QImage before = shown(ViewKind::editedAlbedo);
    press(Qt::Key_K);
    window_->edits().setFactor(kHaemoglobinDermal, 2.0, false);
    const QImage after = shown(ViewKind::editedAlbedo);
    press(Qt::Key_W);
    const int line = static_cast<int>(view().width() * view().wipePosition());
    expectSides(after, before, line);
  }

  void thePictureIsCopied() {
    QCOMPARE(window_->commands().run("compare.copy"), QString());
    const QImage copy = QApplication::clipboard()->image();
    QVERIFY(copy.width() > 200 && copy.height() > 200);
    QVERIFY(copy.width() <= view().width());
  }

  void theExposureOfTheViewIsMarkedAndReset() {
    const QImage neutral = shown(ViewKind::photograph);
    press(Qt::Key_Up, Qt::ControlModifier);
    QVERIFY(shown(ViewKind::photograph) != neutral);
    auto* bar = window_->findChild<AdjustmentBar*>();
    QCOMPARE(bar->adjustment().stops, 0.25);
    bar->findChildren<QDoubleSpinBox*>()[1]->setValue(1.4);
    QCOMPARE(window_->views().adjustment().gamma, 1.4);
    QCOMPARE(window_->commands().run("view.neutral"), QString());
    QVERIFY(shown(ViewKind::photograph) == neutral);
    QVERIFY(bar->adjustment().isNeutral());
  }

 private:
  DocumentPage& page() { return window_->findChild<DocumentTabs*>()->current(); }
  Viewport& view() { return window_->viewport(); }
  void press(Qt::Key key, Qt::KeyboardModifiers modifiers = {}) {
    QTest::keyClick(&view(), key, modifiers);
    waitUntilIdle();
  }
  QImage shown(ViewKind kind) {
    window_->views().show(kind);
    waitUntilIdle();
    return view().grab().toImage();
  }
  // Left of the line the first, right of it the second, a few pixels from either.
  void expectSides(const QImage& first, const QImage& second, int line) {
    const QImage seen = view().grab().toImage();
    QVERIFY(first.size() == seen.size() && second.size() == seen.size());
    const int y = static_cast<int>(kRow * seen.height());
    for (int x = 0; x < seen.width(); x += 3) {
      if (std::abs(x - line) < 12) continue;
      const QRgb wanted = (x < line ? first : second).pixel(x, y);
      QVERIFY2(isClose(seen.pixel(x, y), wanted), qPrintable(QString::number(x)));
    }
  }
  void waitUntilIdle() {
    QTest::qWait(10);
    QTRY_VERIFY_WITH_TIMEOUT(window_->isIdle(), kComparePatienceMs);
  }
  void tearDown() override { window_.reset(); }
  void setUp() override {
    window_ = std::make_unique<MainWindow>(std::make_unique<Engine>(folder_ / "cache"));
    window_->resize(1280, 800);
    window_->show();
    QVERIFY(QTest::qWaitForWindowActive(window_.get()));
    window_->opener().openSample();
    waitUntilIdle();
    window_->edits().setFactor(kMelanin, 2.0, false);
    waitUntilIdle();
  }

  test::ScratchFolder folder_;
  std::unique_ptr<MainWindow> window_;
};

CUTIS_TEST(CompareWindowTest)

}  // namespace
}  // namespace cutis

#include "compare_window_test.moc"
