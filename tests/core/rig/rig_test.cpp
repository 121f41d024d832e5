#include "core/rig/rig.h"

#include <limits>

#include <QtTest>

#include "core/skin/profile/parameter_sampling.h"
#include "tests/support/expect.h"
#include "tests/support/models.h"
#include "tests/support/test_registry.h"

namespace cutis {
namespace {

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
constexpr double kInfinity = std::numeric_limits<double>::infinity();

// A camera that is blind to this light in one channel.
Rig halfBlindRig() {
  Rig rig = test::albedoRig();
  rig.camera.sensor.sensitivity.row(2).setZero();
  rig.camera.sensor.sensitivity.row(2).tail(100) = 1.0;
  rig.lights.front().power.tail(100) = 0.0;
  return rig;
}

class RigTest : public QObject {
  Q_OBJECT

 private slots:
  void aPerfectDiffuserReadsOne() {
    for (const Rig* rig : {&test::monitorRig(), &test::albedoRig()}) {
      const SpectrumRows rows = responseRows(*rig);
      QCOMPARE(static_cast<int>(rows.rows()), rig->channelCount());
      for (Eigen::Index k = 0; k < rows.rows(); ++k)
        EXPECT_NEAR(rows.row(k).sum(), 1.0, 1e-13);
      QVERIFY((rows >= 0.0).all());
    }
  }

  // resources/manual/model.md: Σ R S L / Σ S L, light by light.
  void channelsAreTheRatioOfSums() {
    const Rig& rig = test::monitorRig();
    const SpectrumRows rows = responseRows(rig);
    for (const ParameterVector& p : sampleBox(test::li2024().profile().axes, 20)) {
      const Spectrum r = test::li2024().reflectance(p);
      for (int k = 0; k < 3; ++k) {
        const Spectrum& light = rig.lights[static_cast<std::size_t>(k)].power;
        for (int c = 0; c < 3; ++c) {
          const Spectrum sensor = rig.camera.sensor.sensitivity.row(c).transpose();
          EXPECT_NEAR((rows.row(3 * k + c).transpose() * r).sum(),
                      (r * sensor * light).sum() / (sensor * light).sum(), 1e-13);
        }
      }
    }
  }

  void theMonitorRigIsThePapers() {
    const Rig& rig = test::monitorRig();
    QCOMPARE(rig.channelCount(), 9);
    QCOMPARE(rig.channelName(0), std::string("white.R"));
    QCOMPARE(rig.channelName(4), std::string("white+blue.G"));
    QCOMPARE(rig.channelName(8), std::string("white+green.B"));
    QCOMPARE(rig.lightIndex("white+green"), 2);
    QCOMPARE(rig.lightIndex("flash"), -1);
    EXPECT_NEAR(rig.noise.read, 0.0001, 0.0);
    EXPECT_NEAR(rig.noise.proportional, 0.005, 0.0);
    EXPECT_OK(validate(rig, "monitor"));
  }

  // Brightness of a light or of the camera is calibrated away.
  void scaleDoesNotMatter() {
    Rig rig = test::monitorRig();
    const SpectrumRows before = responseRows(rig);
    rig.lights[1].power *= 12.5;
    rig.camera.sensor.sensitivity *= 0.01;
    QVERIFY((responseRows(rig) - before).abs().maxCoeff() < 1e-15);
  }

  void aDeadChannelIsZeroAndAllowed() {
    const Rig rig = halfBlindRig();
    EXPECT_OK(validate(rig, "rig.json"));
    const SpectrumRows rows = responseRows(rig);
    QVERIFY((rows.row(2) == 0.0).all());
    EXPECT_NEAR(rows.row(0).sum(), 1.0, 1e-13);
  }

  void withLightsSelectsInOrder() {
    const auto rig = withLights(test::monitorRig(), {"white+green", "white"}, "--lights");
    EXPECT_OK(rig);
    QCOMPARE(rig.value().channelCount(), 6);
    QCOMPARE(rig.value().channelName(0), std::string("white+green.R"));
    const SpectrumRows all = responseRows(test::monitorRig());
    const SpectrumRows part = responseRows(rig.value());
    QVERIFY((part.topRows(3) == all.bottomRows(3)).all());
    QVERIFY((part.bottomRows(3) == all.topRows(3)).all());
  }

  void withLightsRefusesWhatIsNotThere() {
    EXPECT_ERROR(withLights(test::monitorRig(), {"white", "flash"}, "--lights"),
                 "--lights: rig 'monitor' has no light 'flash'; it has white, white+blue");
    EXPECT_ERROR(withLights(test::monitorRig(), {"white", "white"}, "--lights"), "twice");
    const auto none = withLights(test::monitorRig(), {}, "--lights");
    EXPECT_ERROR(none, "--lights");
    QVERIFY(none.error().kind == ErrorKind::usage);
  }

  void validateNamesWhatIsWrong_data() {
    QTest::addColumn<int>("fault");
    QTest::addColumn<QString>("message");
    QTest::newRow("no lights") << 0 << "lights is empty";
    QTest::newRow("same name twice") << 1 << "'white'";
    QTest::newRow("negative power") << 2 << "light 'white+blue'";
    QTest::newRow("power not a number") << 3 << "light 'white+blue'";
    QTest::newRow("infinite power") << 4 << "light 'white+blue'";
    QTest::newRow("dark light") << 5 << "no power";
    QTest::newRow("negative sensitivity") << 6 << "column G";
    QTest::newRow("sensitivity not a number") << 7 << "column B";
    QTest::newRow("negative noise") << 8 << "noise";
    QTest::newRow("noise not a number") << 9 << "noise";
    QTest::newRow("infinite noise") << 10 << "noise";
    QTest::newRow("too many lights") << 11 << "list at most 10";
  }
  void validateNamesWhatIsWrong() {
    QFETCH(int, fault);
    QFETCH(QString, message);
    Rig rig = test::monitorRig();
    Spectrum& power = rig.lights[1].power;
    switch (fault) {
      case 0:
        rig.lights.clear();
        break;
      case 1:
        rig.lights[2].name = "white";
        break;
      case 2:
        power[100] = -1e-9;
        break;
      case 3:
        power[0] = kNan;
        break;
      case 4:
        power[350] = kInfinity;
        break;
      case 5:
        power.setZero();
        break;
      case 6:
        rig.camera.sensor.sensitivity(1, 80) = -1.0;
        break;
      case 7:
        rig.camera.sensor.sensitivity(2, 80) = kNan;
        break;
      case 8:
        rig.noise.read = -0.1;
        break;
      case 9:
        rig.noise.proportional = kNan;
        break;
      case 10:
        rig.noise.proportional = kInfinity;
        break;
      default:
        while (rig.lights.size() < 11) {
          rig.lights.push_back(rig.lights.front());
          rig.lights.back().name += std::to_string(rig.lights.size());
        }
    }
    const Status status = validate(rig, "rig.json");
    QVERIFY(status.failed());
    QVERIFY2(status.error().text().find(message.toStdString()) != std::string::npos,
             status.error().text().c_str());
    QCOMPARE(status.error().place, std::string("rig.json"));
    QVERIFY(status.error().kind == ErrorKind::input);
  }

  void fingerprintsTellChannelsApartAndNothingElse() {
    const std::string original = fingerprint(test::monitorRig());
    Rig rig = test::monitorRig();
    rig.name = "other";
    rig.noise.read = 0.1;
    rig.lights[0].name = "plain";
    QCOMPARE(fingerprint(rig), original);
    rig.lights[0].power[200] += 1e-12;
    QVERIFY(fingerprint(rig) != original);
    rig = test::monitorRig();
    rig.camera.sensor.sensitivity(0, 0) += 1e-12;
    QVERIFY(fingerprint(rig) != original);
    rig = test::monitorRig();
    std::swap(rig.lights[0], rig.lights[1]);
    QVERIFY(fingerprint(rig) != original);
    rig = test::monitorRig();
    rig.lights.pop_back();
    QVERIFY(fingerprint(rig) != original);
  }
};

CUTIS_TEST(RigTest)

}  // namespace
}  // namespace cutis

#include "rig_test.moc"
