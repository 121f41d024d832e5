// What a rig tells apart: more channels never know less, and a light that is not seen does not
// help.

#include "core/analyse/rig_study.h"

#include <QtTest>

#include "tests/support/expect.h"
#include "tests/support/models.h"
#include "tests/support/test_registry.h"

namespace cutis {
namespace {

constexpr std::size_t kPeople = 30;

Result<RigStudy> studied(const Rig& rig, const std::vector<RigLight>& candidates) {
  return studyRig(test::li2024(), rig, test::li2024().profile().prior, kPeople, candidates, {});
}

// Nothing that `whole` leaves open is known of `part`.
void expectKnowsMore(const Identifiability& whole, const Identifiability& part) {
  for (std::size_t k = 0; k < whole.left.size(); ++k)
    EXPECT_AT_MOST(whole.left[k].median, part.left[k].median + 1e-12);
  EXPECT_AT_MOST(whole.visible, part.visible + 1e-12);
}

class RigStudyTest : public QObject {
  Q_OBJECT

 private slots:
  void narrowLightsPeakWhereTheyAreNamed() {
    const std::vector<RigLight> lights = narrowLights();
    QCOMPARE(lights.size(), std::size_t{31});
    QCOMPARE(lights.front().name, std::string("360 nm, 20 nm wide"));
    const Spectrum& power = lights.front().power;
    const auto at = [&](int nm) { return power[(nm - kFirstWavelengthNm) / kWavelengthStepNm]; };
    EXPECT_NEAR(at(360), 1.0, 0.0);
    EXPECT_NEAR(at(350), 0.5, 1e-12);
    EXPECT_NEAR(at(370), 0.5, 1e-12);
  }

  void partsKnowLess() {
    const auto study = studied(test::monitorRig(), {});
    EXPECT_OK(study);
    const RigStudy& found = study.value();
    QCOMPARE(found.channels, test::monitorRig().channelCount());
    QVERIFY(found.paper.has_value());
    expectKnowsMore(found.all, *found.paper);
    QCOMPARE(found.alone.size(), test::monitorRig().lights.size());
    for (const LightFigures& one : found.alone)
      expectKnowsMore(found.all, one.result);
    QVERIFY(found.noises.size() > 2);
    for (std::size_t n = 1; n < found.noises.size(); ++n) {
      QVERIFY(found.noises[n].proportional > found.noises[n - 1].proportional);
      expectKnowsMore(found.noises[n - 1].result, found.noises[n].result);
    }
    QVERIFY(found.added.empty());
  }

  void theBestLightComesFirstAndUnseenOnesAreLeftOut() {
    const auto study = studied(test::albedoRig(), narrowLights());
    EXPECT_OK(study);
    const RigStudy& found = study.value();
    QVERIFY(!found.paper && found.alone.empty());
    QVERIFY(!found.added.empty() && found.added.size() <= 8);
    for (const LightFigures& more : found.added) {
      expectKnowsMore(more.result, found.all);
      // The observer is blind there.
      QVERIFY(!more.light.starts_with("9"));
    }
  }

  void theSamePeopleAreDrawnAgain() {
    const auto once = studied(test::albedoRig(), {}), again = studied(test::albedoRig(), {});
    EXPECT_OK(once);
    EXPECT_OK(again);
    EXPECT_NEAR(once.value().all.visible, again.value().all.visible, 0.0);
  }
};

CUTIS_TEST(RigStudyTest)

}  // namespace
}  // namespace cutis

#include "rig_study_test.moc"
