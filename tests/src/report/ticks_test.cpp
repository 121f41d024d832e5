// Round numbers of axes, and where values lie along them.

#include "src/report/plot/ticks.h"

#include <cmath>
#include <limits>

#include <QtTest>

#include "src/report/plot/axis.h"
#include "src/report/plot/scale.h"
#include "tests/support/expect.h"
#include "tests/support/test_registry.h"

namespace cutis::test {
namespace {

const double kNotANumber = std::nan("");
constexpr double kEndless = std::numeric_limits<double>::infinity();

class TicksTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void stepsAreRound() {
    EXPECT_NEAR(niceStep(1, 5), 0.2, 1e-12);
    EXPECT_NEAR(niceStep(0.62, 5), 0.2, 1e-12);
    EXPECT_NEAR(niceStep(0.5, 5), 0.1, 1e-12);
    EXPECT_NEAR(niceStep(700, 7), 100, 1e-9);
    EXPECT_NEAR(niceStep(0, 5), 1, 0);
    EXPECT_NEAR(niceStep(kNotANumber, 5), 1, 0);
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
    QVERIFY(logarithmicTicks(1.0, kEndless, 9).empty());
    QVERIFY(logarithmicTicks(kNotANumber, 1.0, 9).empty());
  }

  void roundEndsHoldTheirValues() {
    for (const auto& [least, most] :
         {std::pair(0.2, 0.9), std::pair(1.0, 1.0), std::pair(3e-3, 7e4), std::pair(20.0, 50.0),
          std::pair(1e-14, 1e-14), std::pair(0.3, 0.3)}) {
      for (const auto& [from, to] : {roundEnds(least, most), decadeEnds(least, most)}) {
        QVERIFY(from <= least * (1.0 + 1e-9) && from > least / 11.0);
        QVERIFY(to >= most * (1.0 - 1e-9) && to < most * 11.0);
        QVERIFY(to > 1.5 * from);
      }
    }
    EXPECT_NEAR(roundEnds(0.2, 0.9).first, 0.2, 1e-12);
    EXPECT_NEAR(roundEnds(0.2, 0.9).second, 1.0, 1e-12);
  }

  void wordsHaveTheDigitsTheyNeed() {
    QCOMPARE(tickWords(0.3, 0.1), std::string("0.3"));
    QCOMPARE(tickWords(20.0, 10.0), std::string("20"));
    QCOMPARE(tickWords(-0.25, 0.05), std::string("−0.25"));
    QCOMPARE(tickWords(-1e-17, 0.1), std::string("0.0"));
    QCOMPARE(tickWords(0.00002, 0.00002), std::string("0.00002"));
  }

  void decadesAreWrittenAsPowers() {
    const Axis axis = decadeAxis(3e-3, 20.0);
    QCOMPARE(axis.ticks.size(), std::size_t(6));
    QCOMPARE(axis.ticks.front().words, std::string("10"));
    QCOMPARE(axis.ticks.front().raised, std::string("−3"));
    QCOMPARE(axis.ticks.back().raised, std::string("2"));
  }

  void valuesHavePlacesThatLeadBack() {
    const Scale scale = {1.0, 100.0, 10.0, 30.0, true};
    EXPECT_NEAR(scale.at(10.0), 20.0, 1e-12);
    EXPECT_NEAR(scale.valueAt(20.0), 10.0, 1e-12);
    QVERIFY(scale.at(1000.0) > 30.0);
    QVERIFY(!std::isfinite(scale.at(0.0)));
    QVERIFY(!std::isfinite(scale.at(-1.0)));
    QVERIFY(!std::isfinite(scale.at(kNotANumber)));
    const Scale linear = {-1.0, 1.0, 100.0, 0.0};
    EXPECT_NEAR(linear.at(0.5), 25.0, 1e-12);
    EXPECT_NEAR(linear.valueAt(25.0), 0.5, 1e-12);
  }

  void anyEndsMakeAScale() {
    for (const bool logarithmic : {false, true}) {
      for (const double from : {kNotANumber, -kEndless, -1.0, 0.0, 2.0, 1e300}) {
        for (const double to : {kNotANumber, kEndless, -1.0, 0.0, 2.0}) {
          const Scale scale = usableScale(from, to, logarithmic, 0.0, 100.0);
          QVERIFY(scale.to > scale.from);
          QVERIFY(std::isfinite(scale.at(scale.from)) && std::isfinite(scale.at(scale.to)));
        }
      }
    }
  }
};

CUTIS_TEST(TicksTest)

}  // namespace
}  // namespace cutis::test

#include "ticks_test.moc"
