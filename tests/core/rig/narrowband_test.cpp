#include "core/rig/narrowband.h"

#include <QtTest>

#include "core/base/random.h"
#include "src/files/spectral_library.h"
#include "tests/support/expect.h"
#include "tests/support/models.h"
#include "tests/support/test_registry.h"

namespace cutis {
namespace {

Spectrum randomReflectance(Random& random) {
  Spectrum r;
  for (int i = 0; i < kSampleCount; ++i)
    r[i] = random.uniform();
  return r;
}

// The response of one sensor to one light alone.
double response(const Rig& rig, int sensor, const Spectrum& light, const Spectrum& reflectance) {
  const Spectrum seen = rig.camera.sensor.sensitivity.row(sensor).transpose() * light;
  return (seen * reflectance).sum() / seen.sum();
}

// A rig of mixes of the monitor's primaries.
Rig rigOf(const std::vector<std::pair<std::string, Eigen::Vector3d>>& mixes) {
  const auto primaries = loadPrimaries({"iset_LCD_Gechic", {}, "test"}).value();
  Rig rig = test::monitorRig();
  rig.lights.clear();
  for (const auto& [name, mix] : mixes) {
    RigLight light;
    light.name = name;
    light.mix = mix;
    for (std::size_t k = 0; k < 3; ++k) {
      light.power += mix[static_cast<Eigen::Index>(k)] * primaries[k];
    }
    rig.lights.push_back(light);
  }
  return rig;
}

class NarrowbandTest : public QObject {
  Q_OBJECT

 private slots:
  // A display adds light, so the difference of two photographs is one of the primary alone.
  void isTheResponseToThePrimaryAlone_data() {
    QTest::addColumn<QVector<double>>("mix");  // white, white+blue, white+green
    QTest::newRow("monitor") << QVector<double>{1, 1, 1, 1. / 3, 1. / 3, 1, 1. / 3, 1, 1. / 3};
    QTest::newRow("no white left") << QVector<double>{1, 1, 1, 0, 0, 1, 0, 1, 0};
    QTest::newRow("scaled") << QVector<double>{2, 2, 2, 0.1, 0.1, 0.7, 3, 9, 3};
    QTest::newRow("tinted white") << QVector<double>{1, .8, .6, .5, .4, 1, .5, .9, .3};
  }
  void isTheResponseToThePrimaryAlone() {
    QFETCH(QVector<double>, mix);
    const Rig rig = rigOf({{"white", {mix[0], mix[1], mix[2]}},
                           {"white+blue", {mix[3], mix[4], mix[5]}},
                           {"white+green", {mix[6], mix[7], mix[8]}}});
    const SearchChannels channels = searchChannels(rig);
    QVERIFY(channels.hasNarrowband());
    const auto primaries = loadPrimaries({"iset_LCD_Gechic", {}, "test"});
    EXPECT_OK(primaries);
    const SpectrumRows rows = responseRows(rig);
    Random random(11);
    for (int i = 0; i < 300; ++i) {
      const Spectrum r = randomReflectance(random);
      const Eigen::VectorXd seen = channels.fromRig * (rows.matrix() * r.matrix());
      for (int c = 0; c < 3; ++c) {
        EXPECT_NEAR(seen[c], response(rig, c, rig.lights[0].power, r), 1e-12);
      }
      EXPECT_NEAR(seen[3], response(rig, 2, primaries.value()[2], r), 1e-9);
      EXPECT_NEAR(seen[4], response(rig, 1, primaries.value()[1], r), 1e-9);
    }
  }

  void theMonitorRigItself() {
    const SearchChannels channels = searchChannels(test::monitorRig());
    QVERIFY(channels.hasNarrowband());
    QCOMPARE(channels.fromRig.rows(), Eigen::Index{5});
    QCOMPARE(channels.fromRig.cols(), Eigen::Index{9});
    // Weights of a synthesised channel add to one: a perfect diffuser reads 1.
    for (int k = 0; k < 5; ++k)
      EXPECT_NEAR(channels.fromRig.row(k).sum(), 1.0, 1e-12);
  }

  void theOrderOfLightsDoesNotMatter() {
    const auto turned =
        withLights(test::monitorRig(), {"white+green", "white", "white+blue"}, "test");
    EXPECT_OK(turned);
    const Eigen::MatrixXd before =
        searchChannels(test::monitorRig()).fromRig * responseRows(test::monitorRig()).matrix();
    const Eigen::MatrixXd after =
        searchChannels(turned.value()).fromRig * responseRows(turned.value()).matrix();
    QVERIFY((after - before).cwiseAbs().maxCoeff() < 1e-15);
  }

  void whiteAloneIsSearchedByWhite() {
    const auto white = withLights(test::monitorRig(), {"white"}, "test");
    EXPECT_OK(white);
    QVERIFY(!searchChannels(white.value()).hasNarrowband());
    QVERIFY(searchChannels(white.value()).fromRig == Eigen::MatrixXd::Identity(3, 3));
    QVERIFY(!searchChannels(test::albedoRig()).hasNarrowband());
    QVERIFY(searchChannels(test::albedoRig()).fromRig == Eigen::MatrixXd::Identity(3, 3));
  }

  void oneMixtureIsNotEnough() {
    const auto two = withLights(test::monitorRig(), {"white+blue", "white"}, "test");
    EXPECT_OK(two);
    const SearchChannels channels = searchChannels(two.value());
    QVERIFY(!channels.hasNarrowband());
    // White is the second light here.
    EXPECT_NEAR(channels.fromRig(0, 3), 1.0, 0.0);
    EXPECT_NEAR(channels.fromRig.sum(), 3.0, 0.0);
  }

  // Mixtures that are not white plus one primary have no narrowband response.
  void otherMixturesAreRefused_data() {
    QTest::addColumn<QVector<double>>("white");
    QTest::addColumn<QVector<double>>("blue");
    QTest::newRow("red left over") << QVector<double>{1, 1, 1} << QVector<double>{0.5, 0.2, 1};
    QTest::newRow("less blue than white") << QVector<double>{1, 1, 1} << QVector<double>{1, 1, 0.5};
    QTest::newRow("the same as white") << QVector<double>{1, 1, 1} << QVector<double>{1, 1, 1};
    QTest::newRow("green that white lacks")
        << QVector<double>{1, 0, 1} << QVector<double>{.3, .5, 1};
  }
  void otherMixturesAreRefused() {
    QFETCH(QVector<double>, white);
    QFETCH(QVector<double>, blue);
    const Rig rig = rigOf({{"white", {white[0], white[1], white[2]}},
                           {"white+blue", {blue[0], blue[1], blue[2]}},
                           {"white+green", {white[0] / 3, 1, white[2] / 3}}});
    QVERIFY(!searchChannels(rig).hasNarrowband());
  }

  void lightsThatAreNoMixesHaveNone() {
    Rig rig = test::monitorRig();
    rig.lights[1].mix.reset();
    QVERIFY(!searchChannels(rig).hasNarrowband());
  }
};

CUTIS_TEST(NarrowbandTest)

}  // namespace
}  // namespace cutis

#include "narrowband_test.moc"
