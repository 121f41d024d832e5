#include "core/simulate/photograph.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include <QtTest>
#include <tbb/global_control.h>

#include "core/skin/parameter_buffer.h"
#include "core/skin/pixel_state.h"
#include "tests/support/expect.h"
#include "tests/support/models.h"
#include "tests/support/test_registry.h"

namespace cutis {
namespace {

constexpr int kWidth = 300;
constexpr int kHeight = 270;
const Rect kAll = {0, 0, kWidth, kHeight};

const SimulatedSkin& skin() {
  static const SimulatedSkin simulated = [] {
    auto result = simulateSkin({}, kWidth, kHeight, 3, test::li2024().profile().axes, nullptr, {});
    return result ? std::move(result).value() : SimulatedSkin();
  }();
  return simulated;
}

std::vector<float> load(const Plane& plane) {
  std::vector<float> values(plane.bounds().pixelCount());
  if (!plane.load(plane.bounds(), values)) values.clear();
  return values;
}

Result<Measurements> shoot(double noise, std::uint64_t seed = 1) {
  return photograph(skin(), test::li2024(), test::albedoRig(), noise, seed, {});
}

class PhotographTest : public QObject {
  Q_OBJECT

 private slots:
  void channelsAreTheModels() {
    for (const Rig* rig : {&test::monitorRig(), &test::albedoRig()}) {
      const auto photographs = photograph(skin(), test::li2024(), *rig, 0.0, 1, {});
      EXPECT_OK(photographs);
      QCOMPARE(photographs.value().channels.size(), static_cast<std::size_t>(rig->channelCount()));
      QCOMPARE(photographs.value().rig.name, rig->name);
      const SpectrumRows rows = responseRows(*rig);
      const auto values = loadParameters(skin().maps, kAll);
      EXPECT_OK(values);
      double squared = 0.0;
      int count = 0;
      for (std::size_t k = 0; k < photographs.value().channels.size(); ++k) {
        const std::vector<float> channel = load(photographs.value().channels[k]);
        for (std::size_t i = 0; i < channel.size(); i += 131) {
          if (!values.value().present[i]) continue;
          ParameterVector p;
          for (const Parameter parameter : kParameters) {
            p[parameter] = values.value().values[static_cast<std::size_t>(parameter)][i];
          }
          const double exact =
              (rows.row(static_cast<Eigen::Index>(k)).transpose() * test::li2024().reflectance(p))
                  .sum();
          EXPECT_NEAR(channel[i], exact, 1e-5);
          squared += (channel[i] - exact) * (channel[i] - exact);
          ++count;
        }
      }
      EXPECT_AT_MOST(std::sqrt(squared / count), 5e-6);
    }
  }

  void noiseIsWhatWasAsked() {
    const auto clean = shoot(0.0);
    EXPECT_OK(clean);
    for (const double noise : {0.002, 0.05}) {
      const auto noisy = shoot(noise);
      EXPECT_OK(noisy);
      std::vector<float> before;
      for (std::size_t k = 0; k < 3; ++k) {
        const std::vector<float> exact = load(clean.value().channels[k]);
        const std::vector<float> seen = load(noisy.value().channels[k]);
        std::vector<float> draws;
        double sum = 0.0, squared = 0.0, together = 0.0;
        for (std::size_t i = 0; i < exact.size(); ++i) {
          const double draw = (seen[i] / exact[i] - 1.0) / noise;
          draws.push_back(static_cast<float>(draw));
          sum += draw;
          squared += draw * draw;
          if (!before.empty()) together += draw * before[i];
        }
        const auto n = static_cast<double>(exact.size());
        EXPECT_NEAR(sum / n, 0.0, 5.0 / std::sqrt(n));
        EXPECT_NEAR(squared / n, 1.0, 5.0 * std::sqrt(2.0 / n));
        EXPECT_NEAR(together / n, 0.0, 5.0 / std::sqrt(n));  // channels are independent
        before = std::move(draws);
      }
    }
  }

  void neverNegative() {
    const auto noisy = shoot(2.0);
    EXPECT_OK(noisy);
    for (const Plane& channel : noisy.value().channels) {
      for (const float value : load(channel))
        QVERIFY(value >= 0.0f && std::isfinite(value));
    }
  }

  void deterministicForAnyThreads() {
    const auto all = shoot(0.01);
    EXPECT_OK(all);
    const tbb::global_control one(tbb::global_control::max_allowed_parallelism, 1);
    const auto single = shoot(0.01);
    EXPECT_OK(single);
    const auto other = shoot(0.01, 2);
    EXPECT_OK(other);
    for (std::size_t k = 0; k < 3; ++k) {
      QVERIFY(load(all.value().channels[k]) == load(single.value().channels[k]));
      QVERIFY(load(all.value().channels[k]) != load(other.value().channels[k]));
    }
  }

  void backgroundIsMaskedAndNoSkin() {
    const auto clean = shoot(0.0);
    EXPECT_OK(clean);
    const std::vector<float> mask = load(skin().mask);
    const std::vector<float> states = load(clean.value().state);
    const std::vector<float> red = load(clean.value().channels[0]);
    const std::vector<float> blue = load(clean.value().channels[2]);
    float lowest = 1.0f, highest = 0.0f;
    for (std::size_t i = 0; i < mask.size(); ++i) {
      const auto expected = mask[i] > 0.0f ? PixelState::solved : PixelState::masked;
      QCOMPARE(states[i], static_cast<float>(expected));
      if (expected == PixelState::solved) continue;
      // These are the observer's X and Z; skin has less Z.
      QVERIFY(blue[i] > 1.2f * red[i]);
      QVERIFY(red[i] > 0.015f && blue[i] < 0.12f);
      lowest = std::min(lowest, red[i]);
      highest = std::max(highest, red[i]);
    }
    QVERIFY(highest > 1.1f * lowest);
  }

  // Maps from a fit: what was not solved is background.
  void plainMapsAreEnough() {
    ChromophoreMaps maps(4, 1);
    const std::array<float, 4> states = {0.0f, 1.0f, 2.0f, 4.0f};
    EXPECT_OK(maps.state.store({0, 0, 4, 1}, states));
    const std::array<float, 4> melanin = {0.02f, 0.0f, 0.0f, 0.02f};
    EXPECT_OK(maps.values[kMelanin].store({0, 0, 4, 1}, melanin));
    const auto photographs = photograph(maps, test::li2024(), test::albedoRig(), 0.0, 1, {});
    EXPECT_OK(photographs);
    const std::vector<float> seen = load(photographs.value().state);
    QVERIFY(seen == (std::vector<float>{0.0f, 1.0f, 1.0f, 0.0f}));
    const std::vector<float> y = load(photographs.value().channels[1]);
    QCOMPARE(y[0], y[3]);
    QVERIFY(y[0] > 3.0f * y[1]);
  }

  void impossibleNoiseIsRefused() {
    EXPECT_ERROR(shoot(-0.1), "the noise must be a standard deviation");
    EXPECT_ERROR(shoot(std::nan("")), "the noise must be a standard deviation");
  }

  void aRigThatSeesNothingPhotographsBlack() {
    Rig blind = test::albedoRig();
    blind.camera.sensor.sensitivity.setZero();
    const auto photographs = photograph(skin(), test::li2024(), blind, 0.0, 1, {});
    EXPECT_OK(photographs);
    for (const float value : load(photographs.value().channels[0]))
      QCOMPARE(value, 0.0f);
  }

  void stopsWhenAsked() {
    std::stop_source source;
    source.request_stop();
    JobContext context;
    context.stop = source.get_token();
    QVERIFY(photograph(skin(), test::li2024(), test::monitorRig(), 0.0, 1, context).cancelled());
  }
};

CUTIS_TEST(PhotographTest)

}  // namespace
}  // namespace cutis

#include "photograph_test.moc"
