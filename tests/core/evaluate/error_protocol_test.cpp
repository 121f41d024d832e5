// The error protocol of resources/manual/accuracy.md: its pixels, its figures and its bound.

#include <cmath>

#include <QtTest>

#include "core/evaluate/error_bound.h"
#include "core/evaluate/error_metrics.h"
#include "tests/support/expect.h"
#include "tests/support/models.h"
#include "tests/support/test_registry.h"

namespace cutis {
namespace {

const ErrorMeter& meter() {
  static const ErrorMeter made(test::li2024(), test::light("D65"), test::light("A"),
                               test::cie1931());
  return made;
}

// [parameter][pixel]
std::vector<float> estimatesOf(const std::vector<ParameterVector>& people) {
  std::vector<float> estimates;
  for (Eigen::Index k = 0; k < kParameterCount; ++k) {
    for (const ParameterVector& person : people)
      estimates.push_back(static_cast<float>(person[k]));
  }
  return estimates;
}

class ErrorProtocolTest : public QObject {
  Q_OBJECT

 private slots:
  void channelsAreThoseOfExactSpectra() {
    const auto people = drawPopulation(protocolPopulation(), 300, 1);
    const auto pixels = ProtocolPixels::create(test::li2024(), test::monitorRig(), people, {});
    EXPECT_OK(pixels);
    const SpectrumRows rows = responseRows(test::monitorRig());
    const std::vector<float> channels = pixels.value().photograph(0.0, 1);
    for (const std::size_t i : {std::size_t{0}, std::size_t{127}, std::size_t{299}}) {
      const Eigen::VectorXd exact = rows.matrix() * test::li2024().reflectance(people[i]).matrix();
      for (Eigen::Index k = 0; k < exact.size(); ++k)
        EXPECT_NEAR(channels[static_cast<std::size_t>(k) * 300 + i], exact[k], 1e-7);
    }
  }

  void noiseIsProportionalAndNormal() {
    const auto pixels = ProtocolPixels::create(test::li2024(), test::monitorRig(),
                                               drawPopulation(protocolPopulation(), 2000, 1), {});
    EXPECT_OK(pixels);
    const auto exact = pixels.value().photograph(0.0, 1);
    const auto noisy = pixels.value().photograph(0.005, 1);
    QVERIFY(noisy == pixels.value().photograph(0.005, 1));
    QVERIFY(noisy != pixels.value().photograph(0.005, 2));
    double mean = 0.0, square = 0.0;
    for (std::size_t i = 0; i < exact.size(); ++i) {
      const double relative = double{noisy[i]} / double{exact[i]} - 1.0;
      mean += relative / static_cast<double>(exact.size());
      square += relative * relative / static_cast<double>(exact.size());
    }
    EXPECT_NEAR(mean, 0.0, 1e-4);
    EXPECT_NEAR(std::sqrt(square), 0.005, 1e-4);
  }

  void encodingsRound() {
    const auto pixels = ProtocolPixels::create(test::li2024(), test::monitorRig(),
                                               drawPopulation(protocolPopulation(), 50, 1), {});
    EXPECT_OK(pixels);
    const auto exact = pixels.value().photograph(0.0, 1);
    const auto half = pixels.value().photograph(0.0, 1, SampleEncoding::half);
    const auto linear = pixels.value().photograph(0.0, 1, SampleEncoding::linear16);
    const auto srgb = pixels.value().photograph(0.0, 1, SampleEncoding::srgb8);
    for (std::size_t i = 0; i < exact.size(); ++i) {
      EXPECT_NEAR(half[i], exact[i], double{exact[i]} / 2048.0);
      EXPECT_NEAR(linear[i], exact[i], 0.51 / 65535.0);
      EXPECT_NEAR(encodeSrgb(double{srgb[i]}), encodeSrgb(double{exact[i]}), 0.51 / 255.0);
      const double step = 255.0 * encodeSrgb(double{srgb[i]});
      EXPECT_NEAR(step, std::round(step), 1e-4);
    }
  }

  void theTruthHasNoError() {
    const auto people = drawPopulation(protocolPopulation(), 200, 1);
    const auto errors = meter().measure(people, estimatesOf(people), {});
    EXPECT_OK(errors);
    const ErrorSummary summary = summarise(errors.value());
    QCOMPARE(summary.pixels, std::size_t{200});
    EXPECT_AT_MOST(summary.visibleMse, 1e-13);
    EXPECT_AT_MOST(summary.deltaE95_A, 1e-4);
    EXPECT_AT_MOST(summary.parameterRmse.maxCoeff(), 5e-8);
  }

  void errorsAreThoseOfTheSpectra() {
    const ParameterVector truth = {0.05, 0.6, 0.03, 0.02, 0.001};
    ParameterVector estimate = truth;
    estimate[kMelanin] = 0.06;
    const auto errors = meter().measure(std::vector{truth}, estimatesOf(std::vector{estimate}), {});
    EXPECT_OK(errors);
    const PixelError& error = errors.value().front();
    const Spectrum difference =
        test::li2024().reflectance(truth) - test::li2024().reflectance(estimate);
    const auto meanSquare = [&](const Band& band) {
      return difference.segment(band.first, band.count()).square().mean();
    };
    EXPECT_NEAR(error.visible, meanSquare(kVisibleBand), 1e-9);
    EXPECT_NEAR(error.ultraviolet, meanSquare(kUltravioletBand), 1e-9);
    EXPECT_NEAR(error.nearInfrared, meanSquare(kNearInfraredBand), 1e-9);
    const SpectrumRows rows = tristimulusRows(test::light("D65"), test::cie1931());
    const auto lab = [&](const ParameterVector& person) {
      return labFromXyz(rows.matrix() * test::li2024().reflectance(person).matrix(),
                        test::daylightWhite());
    };
    EXPECT_NEAR(error.deltaE_D65, deltaE2000(lab(truth), lab(estimate)), 1e-4);
    EXPECT_NEAR(error.typologyAngle, individualTypologyAngle(lab(truth)), 1e-6);
    EXPECT_NEAR(error.parameters[kMelanin], 0.01, 1e-8);
    QVERIFY(error.deltaE_A > 0.1);
  }

  void summariesTakeMeansAndQuantiles() {
    std::vector<PixelError> errors(101);
    for (std::size_t i = 0; i < errors.size(); ++i) {
      errors[i].visible = static_cast<double>(i);
      errors[i].deltaE_D65 = 100.0 - static_cast<double>(i);
      errors[i].parameters[kCarotene] = i % 2 == 0 ? 0.5 : -0.5;
    }
    const ErrorSummary summary = summarise(errors);
    EXPECT_NEAR(summary.visibleMse, 50.0, 1e-9);
    EXPECT_NEAR(summary.medianDeltaE_D65, 50.0, 1e-9);
    EXPECT_NEAR(summary.deltaE95_D65, 95.0, 1e-9);
    EXPECT_NEAR(summary.parameterRmse[kCarotene], 0.5, 1e-9);
    QCOMPARE(summarise({}).pixels, std::size_t{0});
  }

  void tonesAreOrdered() {
    QCOMPARE(toneOf(60.0), 0);
    QCOMPARE(toneOf(41.0), 1);
    QCOMPARE(toneOf(10.5), 1);
    QCOMPARE(toneOf(0.0), 2);
    QCOMPARE(toneOf(-31.0), 3);
  }

  // Two people, one 1 deviation off and one 3, measured well in melanin and not in the blend.
  void coverageCounts() {
    const Prior prior = {
        PriorScale::log, {0.05, 0.6, 0.03, 0.02, 0.001}, {1.0, 0.3, 1.0, 1.0, 1.0}};
    const ParameterVector estimate = prior.mean;
    ParameterVector near = estimate, far = estimate;
    near[kMelanin] *= std::exp(0.1);
    far[kMelanin] *= std::exp(0.3);
    near[kMelaninBlend] += 0.2;
    far[kMelaninBlend] -= 0.6;
    ParameterVector deviation = estimate;
    deviation[kMelanin] *= 0.1;
    deviation[kMelaninBlend] = 0.2;
    const std::vector<ParameterVector> people = {near, far};
    const Coverage coverage = coverageOf(people, estimatesOf({estimate, estimate}),
                                         estimatesOf({deviation, deviation}), prior);
    QCOMPARE(coverage.measured[kMelanin].pixels, std::size_t{2});
    QCOMPARE(coverage.measured[kMelanin].inside, std::size_t{1});
    QCOMPARE(coverage.measured[kMelaninBlend].pixels, std::size_t{0});
    QVERIFY(std::isnan(coverage.measured[kMelaninBlend].share()));
    QCOMPARE(coverage.assumed[kMelaninBlend].inside, std::size_t{1});
    EXPECT_NEAR(coverage.assumed[kHaemoglobinDermal].share(), 1.0, 0.0);
  }

  // resources/manual/accuracy.md: 7.6e-7, 1.4e-6, 3.8e-6, 9.7e-6 for the monitor rig's nine
  // channels.
  void theBoundIsAsDesigned() {
    constexpr std::array<double, 4> noises = {0.001, 0.002, 0.005, 0.01};
    constexpr std::array<double, 4> designed = {7.6e-7, 1.4e-6, 3.8e-6, 9.7e-6};
    const auto people = drawPopulation(protocolPopulation(), 4000, 1);
    const auto bounds = errorBounds(test::li2024(), test::monitorRig(), people,
                                    priorOf(protocolPopulation()), noises, {});
    EXPECT_OK(bounds);
    for (std::size_t i = 0; i < noises.size(); ++i) {
      qInfo("noise %g: visible %.3g, designed %.3g", noises[i], bounds.value()[i].visible,
            designed[i]);
      EXPECT_NEAR(bounds.value()[i].visible, designed[i], 0.15 * designed[i]);
      QVERIFY(bounds.value()[i].ultraviolet > bounds.value()[i].visible);
    }
  }
};

CUTIS_TEST(ErrorProtocolTest)

}  // namespace
}  // namespace cutis

#include "error_protocol_test.moc"
