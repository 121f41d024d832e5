// What the figures of a run say of each other, and the goals they are held against.

#include "src/bench/figures.h"

#include <algorithm>
#include <limits>
#include <set>

#include <QtTest>

#include "src/bench/goals.h"
#include "tests/support/expect.h"
#include "tests/support/test_registry.h"

namespace cutis {
namespace {

PictureFigures picture(BenchMethod method, int size, double seconds, bool scaled = false) {
  PictureFigures row;
  row.content = "uncorrelated";
  row.method = method;
  row.size = size;
  row.seconds = seconds;
  row.scaled = scaled;
  return row;
}

MethodFigures atNoise(BenchMethod method, double noise, double visibleMse) {
  MethodFigures row;
  row.method = method;
  row.noise = noise;
  row.errors.visibleMse = visibleMse;
  return row;
}

const Goal* goalNamed(const std::vector<Goal>& goals, const std::string& key) {
  const auto found =
      std::find_if(goals.begin(), goals.end(), [&](const Goal& goal) { return goal.key == key; });
  return found == goals.end() ? nullptr : &*found;
}

class BenchFiguresTest : public QObject {
  Q_OBJECT

 private slots:
  void everyMethodHasNamesOfItsOwn() {
    std::set<std::string> labels, keys;
    for (const BenchMethod method : kBenchMethods) {
      labels.insert(methodLabel(method));
      keys.insert(methodKey(method));
      QVERIFY(!(isRefined(method) && isExhaustive(method)));
    }
    QCOMPARE(labels.size(), kBenchMethods.size());
    QCOMPARE(keys.size(), kBenchMethods.size());
    QVERIFY(!labels.contains("") && !keys.contains(""));
  }

  void theExactSettingIsJudgedWithoutNoise() {
    QVERIFY(isJudgedAt(BenchMethod::refinedExact, 0.0));
    QVERIFY(!isJudgedAt(BenchMethod::refinedExact, kUsualNoise));
    QVERIFY(isJudgedAt(BenchMethod::refinedWide, kUsualNoise));
  }

  void figuresAreFoundByMethodAndNoise() {
    const std::vector<MethodFigures> all = {atNoise(BenchMethod::network, 0.0, 1e-6),
                                            atNoise(BenchMethod::network, 0.01, 2e-6)};
    QVERIFY(figuresOf(all, BenchMethod::network, 0.01) == &all[1]);
    QVERIFY(figuresOf(all, BenchMethod::network, 0.005) == nullptr);
    QVERIFY(figuresOf(all, BenchMethod::fullSearch, 0.0) == nullptr);
  }

  void runPicturesGoBeforeScaledOnesAndLargerBeforeSmaller() {
    BenchFigures figures;
    QVERIFY(!usualSeconds(figures, BenchMethod::refinedWide));
    figures.sizes = {picture(BenchMethod::refinedWide, 512, 0.1),
                     picture(BenchMethod::refinedWide, 1024, 0.4),
                     picture(BenchMethod::refinedWide, 2048, 9.0, true),
                     picture(BenchMethod::refinedWide, 4096, 7.0),
                     picture(BenchMethod::fullSearch, 1024, 5.0, true)};
    QCOMPARE(largestPicture(figures, BenchMethod::refinedWide)->size, 1024);
    // Four times as many pixels.
    EXPECT_NEAR(*usualSeconds(figures, BenchMethod::refinedWide), 1.6, 1e-12);
    EXPECT_NEAR(*usualSeconds(figures, BenchMethod::fullSearch), 20.0, 1e-12);
  }

  void coverageIsPooledOverParameters() {
    std::array<Coverage::Count, kParameterCount> counts = {};
    counts[0] = {10, 9};
    counts[4] = {30, 28};
    QCOMPARE(pooled(counts).pixels, std::size_t{40});
    QCOMPARE(pooled(counts).inside, std::size_t{37});
  }

  void goalsAreThoseTheFiguresTellOf() {
    BenchFigures figures;
    QVERIFY(goalsOf(figures).empty());
    figures.methods = {atNoise(BenchMethod::refinedExact, 0.0, 4e-8)};
    figures.speedRatio = 300.0;
    const auto goals = goalsOf(figures);
    QCOMPARE(goals.size(), std::size_t{2});
    const Goal* exact = goalNamed(goals, "exact_visible_mse");
    QVERIFY(exact != nullptr && !exact->isMet());
    EXPECT_NEAR(exact->reached, 4e-8, 0.0);
    const Goal* ratio = goalNamed(goals, "speed_ratio");
    QVERIFY(ratio != nullptr && ratio->isMet());
  }

  void goalsMayHaveBothEnds() {
    Goal goal;
    goal.least = 93.0;
    goal.most = 97.0;
    for (const auto& [reached, met] :
         {std::pair{92.9, false}, {93.0, true}, {97.0, true}, {97.1, false}}) {
      goal.reached = reached;
      QCOMPARE(goal.isMet(), met);
    }
    goal.reached = std::numeric_limits<double>::quiet_NaN();
    QVERIFY(!goal.isMet());
  }

  void scaledTimesSaySo() {
    BenchFigures figures;
    figures.sizes = {picture(BenchMethod::refinedWide, 1024, 0.2)};
    const auto goals = goalsOf(figures);
    const Goal* seconds = goalNamed(goals, "refined_seconds");
    QVERIFY(seconds != nullptr);
    EXPECT_NEAR(seconds->reached, 0.8, 1e-12);
    QVERIFY2(seconds->what.find("scaled from 1024²") != std::string::npos, seconds->what.c_str());
  }
};

CUTIS_TEST(BenchFiguresTest)

}  // namespace
}  // namespace cutis

#include "figures_test.moc"
