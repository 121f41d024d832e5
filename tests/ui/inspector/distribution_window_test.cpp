// Histogram and skin locus over the embedded sample.

#include <memory>
#include <numeric>

#include <QCheckBox>
#include <QtTest>

#include "tests/support/scratch_folder.h"
#include "tests/support/test_registry.h"
#include "tests/ui/ui_test.h"
#include "tests/ui/window_steps.h"
#include "ui/commands/command_registry.h"
#include "ui/dialogs/open_controller.h"
#include "ui/inspector/distribution_panel.h"
#include "ui/plot/histogram_plot.h"
#include "ui/plot/locus_plot.h"
#include "ui/view/view_controller.h"
#include "ui/window/main_window.h"

namespace cutis {
namespace {

constexpr int kDistributionPatienceMs = 120000;

double sumOf(const HistogramCurve& curve) {
  return std::accumulate(curve.counts.begin(), curve.counts.end(), 0.0);
}

class DistributionWindowTest : public test::UiTest {
  Q_OBJECT

 private slots:
  void initTestCase() { test::keepSettingsIn(folder_.path()); }

  void nothingIsCountedWhileItIsHidden() { QVERIFY(histogram().spec().curves.empty()); }

  void coloursHaveThreeCurvesAndMapsOne() {
    showDock();
    QCOMPARE(histogram().spec().curves.size(), std::size_t{3});
    QCOMPARE(histogram().spec().axis, QString("linear value, Rec.709"));
    window_->views().show(ViewKind::melanin);
    waitUntilIdle();
    QCOMPARE(histogram().spec().curves.size(), std::size_t{1});
    QCOMPARE(histogram().spec().axis, QString("Melanin"));
    QCOMPARE(histogram().spec().unit, QString("volume fraction"));
    QVERIFY(sumOf(histogram().spec().curves.front()) > 10000.0);
    QVERIFY2(histogram().spec().title.contains(" of "), qPrintable(histogram().spec().title));
  }

  void countsCanBeLogarithmic() {
    showDock();
    auto* box = panel().findChild<QCheckBox*>();
    QTest::mouseClick(box, Qt::LeftButton, {}, QPoint(8, box->height() / 2));
    QVERIFY(histogram().isLogarithmic());
    QVERIFY(!panel().grab().isNull());
  }

  void theLocusIsDrawn() {
    const QImage empty = panel().locus().grab().toImage();
    showDock();
    QTRY_VERIFY(panel().locus().grab().toImage() != empty);
    QVERIFY(panel().locus().placeOf({0.2, 0.47}).x() < panel().locus().placeOf({0.3, 0.47}).x());
  }

 private:
  DistributionPanel& panel() { return *window_->findChild<DistributionPanel*>(); }
  HistogramPlot& histogram() { return panel().histogram(); }
  void showDock() {
    QCOMPARE(window_->commands().run("dock.distribution"), QString());
    QTRY_VERIFY(panel().isVisible());
    waitUntilIdle();
  }
  void waitUntilIdle() {
    QTest::qWait(10);
    QTRY_VERIFY_WITH_TIMEOUT(window_->isIdle(), kDistributionPatienceMs);
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

CUTIS_TEST(DistributionWindowTest)

}  // namespace
}  // namespace cutis

#include "distribution_window_test.moc"
