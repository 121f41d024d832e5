// What a measurement leaves open, against closed forms and against what must hold anyway.

#include "core/analyse/identifiability.h"

#include <cmath>

#include <QtTest>

#include "core/evaluate/error_bound.h"
#include "core/evaluate/error_protocol.h"
#include "core/fit/population.h"
#include "core/rig/narrowband.h"
#include "tests/support/expect.h"
#include "tests/support/models.h"
#include "tests/support/test_registry.h"

namespace cutis {
namespace {

const std::vector<ParameterVector>& people() {
  static const auto drawn = drawPopulation(protocolPopulation(), 100, 3);
  return drawn;
}

const IdentifiabilityStudy& study() {
  static const auto made =
      IdentifiabilityStudy::create(test::li2024(), priorOf(protocolPopulation()), people(), {});
  return made.value();
}

ChannelSet monitorChannels(double noise = 0.005) {
  return {responseRows(test::monitorRig()), {0.0, noise}, {}};
}

class IdentifiabilityTest : public QObject {
  Q_OBJECT

 private slots:
  // Spectra: the Bayesian Cramér–Rao bound, computed elsewhere.
  void spectraAreTheBound() {
    const std::vector<double> noises = {0.001, 0.01};
    const auto bounds = errorBounds(test::li2024(), test::monitorRig(), people(),
                                    priorOf(protocolPopulation()), noises, {});
    EXPECT_OK(bounds);
    for (std::size_t n = 0; n < noises.size(); ++n) {
      const Identifiability found = study().of(monitorChannels(noises[n]));
      const ErrorBound& bound = bounds.value()[n];
      EXPECT_NEAR(found.visible, std::sqrt(bound.visible), 1e-9);
      EXPECT_NEAR(found.ultraviolet, std::sqrt(bound.ultraviolet), 1e-9);
      EXPECT_NEAR(found.nearInfrared, std::sqrt(bound.nearInfrared), 1e-9);
    }
  }

  void nothingMeasuredLeavesThePrior() {
    const Identifiability found = study().of({SpectrumRows::Zero(3, kSampleCount), {}, {}});
    for (int k = 0; k < kParameterCount; ++k) {
      const auto index = static_cast<std::size_t>(k);
      EXPECT_NEAR(found.left[index].median, 1.0, 1e-12);
      QCOMPARE(found.decidedShare[index], 0.0);
    }
  }

  void moreChannelsAndLessNoiseNeverHurt() {
    Rig white = test::monitorRig();
    white.lights = {white.lights.front()};
    const Identifiability one = study().of({responseRows(white), {0.0, 0.005}, {}});
    const Identifiability all = study().of(monitorChannels());
    const Identifiability clean = study().of(monitorChannels(0.001));
    for (std::size_t k = 0; k < all.left.size(); ++k) {
      QVERIFY(all.left[k].median <= one.left[k].median);
      QVERIFY(clean.left[k].median <= all.left[k].median);
      QVERIFY(all.left[k].low <= all.left[k].median && all.left[k].median <= all.left[k].high);
    }
  }

  // An invertible combination keeps what was known; one that drops channels loses.
  void combinations() {
    ChannelSet mixed = monitorChannels();
    mixed.combination = Eigen::MatrixXd::Identity(9, 9);
    mixed.combination(0, 5) = 2.0;
    mixed.combination(7, 1) = -0.5;
    const Identifiability all = study().of(monitorChannels());
    const Identifiability same = study().of(mixed);
    ChannelSet five = monitorChannels();
    five.combination = searchChannels(test::monitorRig()).fromRig;
    const Identifiability fewer = study().of(five);
    for (std::size_t k = 0; k < all.left.size(); ++k) {
      EXPECT_NEAR(same.left[k].median, all.left[k].median, 1e-6);
      QVERIFY(fewer.left[k].median >= all.left[k].median - 1e-9);
    }
    QVERIFY(fewer.visible > all.visible);
  }

  void logarithmsWhereThePriorHasThem() {
    const Prior& prior = test::li2024().profile().prior;
    const auto made = IdentifiabilityStudy::create(test::li2024(), prior, people(), {});
    EXPECT_OK(made);
    const Identifiability found = made.value().of(monitorChannels());
    for (const Spread& spread : found.left)
      QVERIFY(spread.low > 0.0 && spread.high <= 1.0 + 1e-12);
    QVERIFY(found.left[kMelanin].median < 0.5);
  }
};

CUTIS_TEST(IdentifiabilityTest)

}  // namespace
}  // namespace cutis

#include "identifiability_test.moc"
