#include "ui/color/color_bar_control.h"

#include <algorithm>
#include <cmath>

#include <QSignalSpy>
#include <QtTest>

#include "tests/support/expect.h"
#include "tests/support/test_registry.h"
#include "tests/ui/ui_test.h"

namespace cutis {
namespace {

class ColorBarControlTest : public test::UiTest {
  Q_OBJECT

 private slots:
  void positionsAndValuesAreInverse() {
    for (const DisplayRange& range : {DisplayRange{0.02, 0.4}, DisplayRange{0.02, 0.4, true}}) {
      for (const double position : {-0.1, 0.0, 0.3, 1.0, 1.2})
        EXPECT_NEAR(PositionIn(range)(valueAt(range, position)), position, 1e-12);
    }
    QVERIFY(PositionIn(DisplayRange{0.02, 0.4, true})(0.0) < 0.0);
    QVERIFY(std::isnan(PositionIn(DisplayRange{0.02, 0.4, true})(std::nan(""))));
    EXPECT_NEAR(valueAt({0.01, 0.25, true}, 0.5), 0.05, 1e-12);
  }

  void theSpreadCountsEveryValueOnTheAxis() {
    std::vector<float> sorted;
    for (int i = 0; i < 1000; ++i)
      sorted.push_back(0.0001f * static_cast<float>(i));
    const std::vector<float> even = heightsAlong({0.0, 0.1}, sorted, 10);
    QVERIFY(std::all_of(even.begin(), even.end(), [](float h) { return h > 0.98f; }));
    const std::vector<float> half = heightsAlong({0.0, 0.2}, sorted, 10);
    QVERIFY(half[2] > 0.98f && half[7] == 0.0f);
    QVERIFY(heightsAlong({0.5, 0.6}, sorted, 10).empty());
    const DisplayRange usual = rangeOfValues(sorted, false);
    const DisplayRange axis = axisAround(usual, sorted);
    QVERIFY(axis.minimum >= 0.0 && axis.minimum < usual.minimum && axis.maximum > usual.maximum);
    QVERIFY(rangeOfValues(sorted, true).minimum > 0.0);
  }

  void aHandleIsDragged() {
    makeBar();
    QSignalSpy moved(bar_.get(), &ColorBarControl::rangeMoved);
    follow();
    const QPoint from = bar_->handleAt(true).toPoint();
    QTest::mousePress(bar_.get(), Qt::LeftButton, {}, from);
    QTest::mouseMove(bar_.get(), from - QPoint(40, 0));
    QVERIFY(moved.count() >= 1);
    const DisplayRange range = bar_->spec()->range;
    QVERIFY(range.maximum < 0.2 && range.minimum == 0.02);
    // Beyond the other handle it stays short of it.
    QTest::mouseMove(bar_.get(), {-50, from.y()});
    QVERIFY(bar_->spec()->range.maximum > 0.02);
    QTest::mouseRelease(bar_.get(), Qt::LeftButton, {}, {-50, from.y()});
  }

  void aDoubleClickMakesItAutomatic() {
    makeBar();
    QSignalSpy automatic(bar_.get(), &ColorBarControl::automaticWanted);
    QTest::mouseDClick(bar_.get(), Qt::LeftButton, {}, bar_->rect().center());
    QCOMPARE(automatic.count(), 1);
    bar_->setFocus();
    QTest::keyClick(bar_.get(), Qt::Key_Home);
    QCOMPARE(automatic.count(), 2);
  }

  void keysMoveTheHandles() {
    makeBar();
    follow();
    QTest::keyClick(bar_.get(), Qt::Key_Left);
    const double once = bar_->spec()->range.maximum;
    QVERIFY(once < 0.2);
    QTest::keyClick(bar_.get(), Qt::Key_Right, Qt::ShiftModifier);
    QVERIFY(bar_->spec()->range.maximum > once && bar_->spec()->range.maximum < 0.2);
    QTest::keyClick(bar_.get(), Qt::Key_Down);
    QTest::keyClick(bar_.get(), Qt::Key_Right);
    QVERIFY(bar_->spec()->range.minimum > 0.02);
  }

  void whatHasNoAxisStaysAsItIs() {
    makeBar();
    ColorBarSpec fixed = *bar_->spec();
    fixed.axis.reset();
    bar_->setSpec(fixed);
    QSignalSpy moved(bar_.get(), &ColorBarControl::rangeMoved);
    QTest::mousePress(bar_.get(), Qt::LeftButton, {}, bar_->rect().center());
    QTest::mouseMove(bar_.get(), bar_->rect().center() + QPoint(30, 0));
    QTest::mouseRelease(bar_.get(), Qt::LeftButton, {}, bar_->rect().center());
    QTest::keyClick(bar_.get(), Qt::Key_Left);
    QCOMPARE(moved.count(), 0);
  }

 private:
  void makeBar() {
    bar_ = std::make_unique<ColorBarControl>(nullptr);
    ColorBarSpec spec{"Melanin", "volume fraction", {0.02, 0.2}, ScaleKind::sequential, {}, true};
    spec.axis = DisplayRange{0.0, 0.25};
    spec.heights = {0.1f, 0.5f, 1.0f, 0.4f, 0.0f};
    bar_->setSpec(spec);
    bar_->setPlace({10, 400}, {1200, 900});
    bar_->show();
    QVERIFY(bar_->isVisible());
  }
  // As the view does.
  void follow() {
    connect(bar_.get(), &ColorBarControl::rangeMoved, this, [this](const DisplayRange& range) {
      ColorBarSpec spec = *bar_->spec();
      spec.range = range;
      bar_->setSpec(spec);
    });
  }
  void tearDown() override { bar_.reset(); }

  std::unique_ptr<ColorBarControl> bar_;
};

CUTIS_TEST(ColorBarControlTest)

}  // namespace
}  // namespace cutis

#include "color_bar_control_test.moc"
