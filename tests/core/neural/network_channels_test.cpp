// Which channels a network takes, and whose they are.

#include "core/neural/network_channels.h"

#include <QtTest>

#include "core/rig/narrowband.h"
#include "tests/support/expect.h"
#include "tests/support/models.h"
#include "tests/support/test_registry.h"

namespace cutis {
namespace {

// A rig whose rows another processor rounded.
Rig rounded(Rig rig) {
  double factor = 1.0;
  for (RigLight& light : rig.lights) {
    for (double& power : light.power) {
      factor = factor > 1.0 ? 1.0 - 3e-16 : 1.0 + 5e-16;
      power *= factor;
    }
  }
  return rig;
}

class NetworkChannelsTest : public QObject {
  Q_OBJECT

 private slots:
  void allOrFive() {
    const NetworkChannels all = networkChannels(test::monitorRig());
    QCOMPARE(all.inputCount(), 9);
    QCOMPARE(all.names.front(), std::string("white.R"));
    const auto five = paperNetworkChannels(test::monitorRig(), "");
    EXPECT_OK(five);
    QCOMPARE(five.value().inputCount(), 5);
    QVERIFY(five.value().names.back() == "sg");
    // sb of a spectrum is what the blue primary alone would show.
    const Eigen::MatrixXd white = Eigen::MatrixXd::Ones(1, 9);
    QVERIFY(five.value().inputs(white).isOnes(1e-12));
    EXPECT_ERROR(paperNetworkChannels(test::albedoRig(), "--channels"),
                 "--channels: the paper's channels sb and sg");
  }

  void networksFindTheirChannels() {
    const Rig& monitor = test::monitorRig();
    const NetworkChannels all = networkChannels(monitor);
    const auto five = paperNetworkChannels(monitor, "");
    EXPECT_OK(five);
    for (const Rig& rig : {monitor, rounded(monitor)}) {
      const auto nine = channelsOf(signatureOf(all), rig);
      QVERIFY(nine && nine->combination.size() == 0);
      const auto paper = channelsOf(signatureOf(five.value()), rig);
      QVERIFY(paper && paper->inputCount() == 5);
    }
    QVERIFY((responseRows(rounded(monitor)) != responseRows(monitor)).any());
  }

  void anyRealChangeIsAnotherRig() {
    const Signature all = signatureOf(networkChannels(test::monitorRig()));
    QVERIFY(!channelsOf(all, test::albedoRig()));
    Rig swapped = test::monitorRig();
    std::swap(swapped.lights[1], swapped.lights[2]);
    QVERIFY(!channelsOf(all, swapped));
    for (const int sample : {75, 120, 160}) {
      Rig other = test::monitorRig();
      other.lights[0].power[sample] *= 1.05;
      QVERIFY2(!channelsOf(all, other), std::to_string(sample).c_str());
    }
    Rig camera = test::monitorRig();
    camera.camera.sensor.sensitivity.row(2) *= 2.0;
    QVERIFY2(channelsOf(all, camera), "a gain changes no calibrated channel");
    QVERIFY(!channelsOf({}, test::monitorRig()));
  }
};

CUTIS_TEST(NetworkChannelsTest)

}  // namespace
}  // namespace cutis

#include "network_channels_test.moc"
