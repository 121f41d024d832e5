// More than maps in the strip of views: uncertainty, photographs, bands, and hatching over maps, on
// the embedded sample.

#include <memory>

#include <QLabel>
#include <QSlider>
#include <QtTest>

#include "tests/support/scratch_folder.h"
#include "tests/support/test_registry.h"
#include "tests/ui/ui_test.h"
#include "tests/ui/window_steps.h"
#include "ui/commands/command_registry.h"
#include "ui/dialogs/open_controller.h"
#include "ui/docks/edit_controller.h"
#include "ui/view/band_scrubber.h"
#include "ui/view/view_controller.h"
#include "ui/view/view_delegate.h"
#include "ui/view/view_strip.h"
#include "ui/view/viewport.h"
#include "ui/window/main_window.h"

namespace cutis {
namespace {

constexpr int kLayersPatienceMs = 120000;

class LayersWindowTest : public test::UiTest {
  Q_OBJECT

 private slots:
  void initTestCase() { test::keepSettingsIn(folder_.path()); }

  // In groups, at the height of a usual screen without scrolling.
  void theStripHasEveryLayer() {
    window_->resize(1920, 1040);
    waitUntilIdle();
    const auto* strip = window_->findChild<ViewStrip*>();
    QStringList headings, ids;
    for (int row = 0; row < strip->count(); ++row) {
      const QListWidgetItem* item = strip->item(row);
      const bool isHeading = item->data(ViewDelegate::kHeadingRole).toBool();
      (isHeading ? headings : ids)
          << (isHeading ? item->text() : item->data(ViewDelegate::kIdRole).toString());
      if (!isHeading) QVERIFY(!item->data(ViewDelegate::kThumbnailRole).value<QImage>().isNull());
    }
    QCOMPARE(headings,
             (QStringList{"Pictures", "Maps", "Uncertainty", "Predicted bands", "Photographs"}));
    for (const char* id : {"melanin_deviation", "carotene_deviation", "residual", "band", "light3"})
      QVERIFY2(ids.contains(id), id);
    QVERIFY(!ids.contains("shading") && !ids.contains("light4"));
    const QRect last = strip->visualItemRect(strip->item(strip->count() - 1));
    QVERIFY2(last.bottom() <= strip->viewport()->height(),
             qPrintable(QString::number(last.bottom())));
  }

  void aDeviationIsShownAndStaysUnderEdits() {
    QCOMPARE(window_->commands().run("view.melanin_deviation"), QString());
    waitUntilIdle();
    QVERIFY(window_->viewport().colorBar()->isKnown);
    const QImage before = pictureOf();
    window_->edits().setFactor(kMelanin, 1.5, false);
    waitUntilIdle();
    QVERIFY(pictureOf() == before);
    QCOMPARE(window_->viewport().colorBar()->state, QString());
  }

  void theScrubberChoosesTheWavelength() {
    BandScrubber& scrubber = window_->viewport().bandScrubber();
    QVERIFY(!scrubber.isVisible());
    window_->views().show(ViewKind::band);
    waitUntilIdle();
    QVERIFY(scrubber.isVisible());
    const QImage before = pictureOf();
    auto* slider = scrubber.findChild<QSlider*>();
    QTest::keyClick(slider, Qt::Key_Home);
    waitUntilIdle();
    QCOMPARE(scrubber.wavelengthNm(), 300.0);
    QVERIFY(pictureOf() != before);
    QVERIFY(slider->accessibleDescription().contains("predicted"));
    scrubber.setWavelengthNm(550.0);
    waitUntilIdle();
    QVERIFY(!slider->accessibleDescription().contains("predicted"));
    window_->views().show(ViewKind::melanin);
    QVERIFY(!scrubber.isVisible());
    waitUntilIdle();
  }

  void hatchingLiesOverTheMapAndIsExplained() {
    window_->views().show(ViewKind::melaninBlend);
    waitUntilIdle();
    const QImage before = pictureOf();
    const QStringList ids = {"hatch.notSkin", "hatch.atBound", "hatch.assumed"};
    for (const QString& id : ids)
      QCOMPARE(window_->commands().run(id), QString());
    waitUntilIdle();
    QVERIFY(pictureOf() != before);
    const PixelMarks marks = window_->viewport().colorBar()->marks;
    QCOMPARE(int{marks}, kNotSkin | kAtBound | kMostlyPrior);
    for (const QString& id : ids)
      QCOMPARE(window_->commands().run(id), QString());
    waitUntilIdle();
    QVERIFY(pictureOf() == before);
  }

 private:
  QImage pictureOf() const { return window_->viewport().grab().toImage(); }
  void waitUntilIdle() {
    QTest::qWait(10);
    QTRY_VERIFY_WITH_TIMEOUT(window_->isIdle(), kLayersPatienceMs);
  }
  void tearDown() override { window_.reset(); }
  void setUp() override {
    window_ = std::make_unique<MainWindow>(std::make_unique<Engine>(folder_ / "cache"));
    window_->resize(1280, 800);
    window_->show();
    window_->opener().openSample();
    waitUntilIdle();
  }

  test::ScratchFolder folder_;
  std::unique_ptr<MainWindow> window_;
};

CUTIS_TEST(LayersWindowTest)

}  // namespace
}  // namespace cutis

#include "layers_window_test.moc"
