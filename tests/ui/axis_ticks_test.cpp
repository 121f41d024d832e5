#include "ui/plot/axis_ticks.h"

#include <cmath>
#include <limits>

#include <QtTest>

#include "tests/support/expect.h"
#include "tests/support/test_registry.h"

namespace cutis {
namespace {

class AxisTicksTest : public QObject {
  Q_OBJECT

 private slots:
  void initTestCase() { QLocale::setDefault(QLocale::c()); }

  void stepsAreRound() {
    EXPECT_NEAR(niceStep(1, 5), 0.2, 1e-12);
    EXPECT_NEAR(niceStep(0.62, 5), 0.2, 1e-12);
    EXPECT_NEAR(niceStep(0.5, 5), 0.1, 1e-12);
    EXPECT_NEAR(niceStep(700, 7), 100, 1e-9);
    EXPECT_NEAR(niceStep(0, 5), 1, 0);
    EXPECT_NEAR(niceStep(std::nan(""), 5), 1, 0);
  }

  void ceilingsHoldTheValue() {
    EXPECT_NEAR(niceCeiling(0.62, 5), 0.8, 1e-12);
    EXPECT_NEAR(niceCeiling(0.3, 5), 0.3, 1e-12);
    EXPECT_NEAR(niceCeiling(1, 5), 1, 1e-12);
  }

  void ticksIncludeTheEnds() {
    const std::vector<double> ticks = ticksWithin(0, 0.3, 0.1);
    QCOMPARE(ticks.size(), std::size_t(4));
    EXPECT_NEAR(ticks.back(), 0.3, 1e-12);
  }

  void logarithmicTicksAreRoundAndNotTooMany() {
    const std::vector<double> fine = logarithmicTicks(0.001, 0.02, 9);
    const std::vector<double> expected = {0.001, 0.002, 0.005, 0.01, 0.02};
    QCOMPARE(fine.size(), expected.size());
    for (std::size_t i = 0; i < fine.size(); ++i)
      EXPECT_NEAR(fine[i], expected[i], 1e-12);
    QCOMPARE(logarithmicTicks(0.001, 0.02, 4).size(), std::size_t(2));
    QVERIFY(logarithmicTicks(0.0, 1.0, 9).empty());
    QVERIFY(logarithmicTicks(1.0, 0.5, 9).empty());
    QVERIFY(logarithmicTicks(1.0, std::numeric_limits<double>::infinity(), 9).empty());
    QVERIFY(logarithmicTicks(std::nan(""), 1.0, 9).empty());
  }

  void textsHaveTheDigitsTheyNeed() {
    QCOMPARE(tickText(0.3, 0.1), QString("0.3"));
    QCOMPARE(tickText(20, 10), QString("20"));
    QCOMPARE(rangeTexts(0, 0.25)[1], QString("0.125"));
    QCOMPARE(rangeTexts(0, 0.2)[2], QString("0.2"));
    QCOMPARE(rangeTexts(-1, 1)[1], QString("0"));
    QCOMPARE(rangeTexts(0, 0.0317)[2], QString("0.0317"));
  }
};

CUTIS_TEST(AxisTicksTest)

}  // namespace
}  // namespace cutis

#include "axis_ticks_test.moc"
