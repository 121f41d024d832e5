// The Wiener estimate against closed forms: of a straight line, of a parabola, of channels that say
// nothing, and against the textbook's other form of the same matrix.

#include "core/evaluate/wiener_estimate.h"

#include <cmath>
#include <limits>

#include <Eigen/LU>
#include <QtTest>

#include "core/base/random.h"
#include "tests/support/expect.h"
#include "tests/support/test_registry.h"

namespace cutis {
namespace {

Eigen::MatrixXd drawnMatrix(Eigen::Index rows, Eigen::Index columns, std::uint64_t seed) {
  Random random(seed);
  Eigen::MatrixXd values(rows, columns);
  for (Eigen::Index j = 0; j < columns; ++j) {
    for (Eigen::Index i = 0; i < rows; ++i)
      values(i, j) = random.uniform(0.1, 0.7);
  }
  return values;
}

class WienerEstimateTest : public QObject {
  Q_OBJECT

 private slots:
  // One channel: a slope of cov(s, y) / (var(y) + σ²) through the means.
  void oneChannelIsAShrunkLine() {
    const Eigen::MatrixXd channel{{0.1, 0.2, 0.4, 0.5}};
    const Eigen::MatrixXd spectrum{{0.3, 0.5, 0.7, 0.9}};
    const double read = 0.1;
    const WienerEstimate wiener(WienerFeatures::channels, channel, spectrum, {read, 0.0, 0.0});
    // Means 0.3 and 0.6; covariance (0.2·0.3 + 0.1·0.1 + 0.1·0.1 + 0.2·0.3) / 4; variance 0.025.
    const double slope = 0.035 / (0.025 + read * read);
    EXPECT_NEAR(wiener.estimate(Eigen::MatrixXd{{0.45}})(0, 0), 0.6 + slope * 0.15, 1e-12);
  }

  void noiseFollowsTheChannels() {
    const Eigen::MatrixXd channel{{0.1, 0.2, 0.4, 0.5}};
    const double share = 0.2;
    const WienerEstimate wiener(WienerFeatures::channels, channel, channel, {0.0, share, 0.0});
    // Mean square of the channel: 0.115.
    const double slope = 0.025 / (0.025 + share * share * 0.115);
    EXPECT_NEAR(wiener.estimate(Eigen::MatrixXd{{0.5}})(0, 0), 0.3 + slope * 0.2, 1e-9);
  }

  // (C + N)⁻¹ by the channels is the same as by the spectra: A Fᵀ (F A Fᵀ + N)⁻¹ of a covariance A
  // of spectra and channels y = F s.
  void channelsOfSpectraTakeTheTextbookMatrix() {
    const Eigen::MatrixXd spectra = drawnMatrix(6, 40, 1), responses = drawnMatrix(3, 6, 2);
    const double read = 0.03;
    const WienerEstimate wiener(WienerFeatures::channels, responses * spectra, spectra,
                                {read, 0.0, 0.0});
    const Eigen::VectorXd mean = spectra.rowwise().mean();
    const Eigen::MatrixXd centred = spectra.colwise() - mean;
    const Eigen::MatrixXd covariance = centred * centred.transpose() / 40.0;
    const Eigen::MatrixXd seen = responses * covariance * responses.transpose() +
                                 read * read * Eigen::MatrixXd::Identity(3, 3);
    const Eigen::MatrixXd gain = covariance * responses.transpose() * seen.inverse();
    const Eigen::MatrixXd channels = responses * drawnMatrix(6, 5, 3);
    const Eigen::MatrixXd expected =
        (gain * (channels.colwise() - responses * mean)).colwise() + mean;
    EXPECT_AT_MOST((wiener.estimate(channels) - expected).cwiseAbs().maxCoeff(), 1e-12);
  }

  void parabolasTakeSquares() {
    Eigen::MatrixXd channels = drawnMatrix(2, 60, 4);
    const auto parabola = [](const Eigen::MatrixXd& y) -> Eigen::MatrixXd {
      const auto first = y.row(0).array(), second = y.row(1).array();
      return (0.2 + first - 0.5 * second * second + 0.7 * first * second).matrix();
    };
    const Eigen::MatrixXd other = drawnMatrix(2, 20, 5);
    const auto error = [&](WienerFeatures features) {
      const WienerEstimate wiener(features, channels, parabola(channels), {0.0, 0.0, 0.0});
      return (wiener.estimate(other) - parabola(other)).cwiseAbs().maxCoeff();
    };
    EXPECT_AT_MOST(error(WienerFeatures::channelsAndSquares), 1e-6);
    QVERIFY(error(WienerFeatures::channels) > 1e-3);
  }

  void channelsThatAreAllNoiseGiveTheMean() {
    const Eigen::MatrixXd channels = drawnMatrix(3, 30, 6), spectra = drawnMatrix(4, 30, 7);
    for (const auto features : {WienerFeatures::channels, WienerFeatures::channelsAndSquares}) {
      const WienerEstimate wiener(features, channels, spectra, {1e4, 0.0, 0.0});
      const Eigen::MatrixXd estimate = wiener.estimate(channels);
      EXPECT_AT_MOST((estimate.colwise() - spectra.rowwise().mean()).cwiseAbs().maxCoeff(), 1e-6);
    }
  }

  void whatWasNotMeasuredIsNotEstimated() {
    const Eigen::MatrixXd channels = drawnMatrix(3, 30, 8);
    Eigen::MatrixXd spectra = drawnMatrix(4, 30, 9);
    spectra.row(2).setConstant(std::numeric_limits<double>::quiet_NaN());
    const Eigen::MatrixXd estimate =
        WienerEstimate(WienerFeatures::channelsAndSquares, channels, spectra, {})
            .estimate(channels);
    for (Eigen::Index i = 0; i < estimate.rows(); ++i)
      QCOMPARE(std::isnan(estimate.row(i).sum()), i == 2);
  }
};

CUTIS_TEST(WienerEstimateTest)

}  // namespace
}  // namespace cutis

#include "wiener_estimate_test.moc"
