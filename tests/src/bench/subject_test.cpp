// The people of the benchmark, and the profiles that can hold them.

#include "src/bench/subject.h"

#include <QtTest>

#include "core/fit/population.h"
#include "tests/support/expect.h"
#include "tests/support/models.h"
#include "tests/support/test_registry.h"

namespace cutis {
namespace {

class BenchSubjectTest : public QObject {
  Q_OBJECT

 private slots:
  void fewerPeopleAreTheFirstOfMore() {
    const auto few = benchPeople(10), many = benchPeople(50);
    QCOMPARE(few.size(), std::size_t{10});
    QCOMPARE(many.size(), std::size_t{50});
    const ParameterBox box = protocolPopulation();
    for (std::size_t i = 0; i < few.size(); ++i) {
      QVERIFY((few[i] == many[i]).all());
      QVERIFY((few[i] >= box.low).all() && (few[i] <= box.high).all());
    }
  }

  void theProfileMustHoldTheProtocol() {
    Profile profile = test::li2024().profile();
    EXPECT_OK(checkHoldsProtocol(profile));
    profile.axes[kCarotene].maximum = 0.5 * protocolPopulation().high[kCarotene];
    EXPECT_ERROR(checkHoldsProtocol(profile), "the range of carotene does not hold");
  }

  void theMeterFindsNoErrorInTheTruth() {
    const auto meter = protocolMeter(test::li2024());
    EXPECT_OK(meter);
    const auto people = benchPeople(20);
    std::vector<float> exact;
    for (Eigen::Index k = 0; k < kParameterCount; ++k) {
      for (const ParameterVector& person : people)
        exact.push_back(static_cast<float>(person[k]));
    }
    const auto errors = meter.value()->measure(people, exact, {});
    EXPECT_OK(errors);
    // What rounding to float leaves.
    EXPECT_AT_MOST(summarise(errors.value()).visibleMse, 1e-13);
    EXPECT_AT_MOST(summarise(errors.value()).medianDeltaE_D65, 1e-3);
  }
};

CUTIS_TEST(BenchSubjectTest)

}  // namespace
}  // namespace cutis

#include "subject_test.moc"
