#include "core/fit/population.h"

#include <cmath>

#include <QtTest>

#include "tests/support/expect.h"
#include "tests/support/models.h"
#include "tests/support/test_registry.h"

namespace cutis {
namespace {

class PopulationTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void peopleOfThePriorKeepToTheRanges() {
    const Profile& profile = test::li2024().profile();
    const auto people = drawFromPrior(profile.prior, profile.axes, 4000, 1);
    const auto others = drawFromPrior(profile.prior, profile.axes, 4000, 2);
    QVERIFY(people.front()[kMelanin] != others.front()[kMelanin]);
    double meanLog = 0.0;
    for (const ParameterVector& person : people) {
      for (std::size_t k = 0; k < kParameterCount; ++k) {
        const double value = person[static_cast<Eigen::Index>(k)];
        QVERIFY(value >= 0.0 && value <= profile.axes[k].maximum);
      }
      meanLog += std::log(person[kHaemoglobinEpidermal]) / 4000.0;
    }
    // The range cuts off one in three hundred.
    EXPECT_NEAR(meanLog, std::log(profile.prior.mean[kHaemoglobinEpidermal]), 0.06);
  }

  // Nobody of this prior is inside; the draw ends all the same, at the border.
  void aPriorOutsideOfTheRangesEnds() {
    const Profile& profile = test::li2024().profile();
    Prior prior = profile.prior;
    prior.mean[kMelanin] = 1e6;
    prior.deviation[kMelanin] = 1e-3;
    for (const ParameterVector& person : drawFromPrior(prior, profile.axes, 100, 1)) {
      QCOMPARE(person[kMelanin], profile.axes[kMelanin].maximum);
    }
  }
};

CUTIS_TEST(PopulationTest)

}  // namespace
}  // namespace cutis

#include "population_test.moc"
