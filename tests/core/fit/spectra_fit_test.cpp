#include "core/fit/spectra/spectra_fit.h"

#include <algorithm>
#include <cmath>
#include <random>

#include <QtTest>

#include "core/fit/reference/map_estimator.h"
#include "core/maths/bounded_step.h"
#include "core/skin/profile/parameter_sampling.h"
#include "tests/support/expect.h"
#include "tests/support/models.h"
#include "tests/support/test_registry.h"

namespace cutis {
namespace {

const SkinModel& spectraModel() {
  return test::li2024();
}

// Wavelengths in steps of 10 nm.
std::vector<double> wavelengths(double from = 400.0, double to = 700.0) {
  std::vector<double> nm;
  for (double w = from; w <= to; w += 10.0)
    nm.push_back(w);
  return nm;
}

double interpolated(const Spectrum& spectrum, double nm) {
  const double position = (nm - kFirstWavelengthNm) / kWavelengthStepNm;
  const int below = std::min(static_cast<int>(position), kSampleCount - 2);
  const double share = position - below;
  return (1.0 - share) * spectrum[below] + share * spectrum[below + 1];
}

std::vector<double> spectraOf(const std::vector<ParameterVector>& people,
                              const std::vector<double>& nm, double noise = 0.0) {
  std::mt19937 random(11);
  std::normal_distribution<double> normal;
  std::vector<double> values;
  for (const ParameterVector& person : people) {
    const Spectrum spectrum = spectraModel().reflectance(person);
    for (const double w : nm) {
      values.push_back(std::max(0.0, interpolated(spectrum, w) + noise * normal(random)));
    }
  }
  return values;
}

std::vector<SpectrumFit> fit(const std::vector<double>& nm, const std::vector<double>& values) {
  return fitSpectra(spectraModel(), nm, values, {}).value();
}

double rmse(const ParameterVector& parameters, const std::vector<double>& nm,
            const double* measured) {
  const Spectrum spectrum = spectraModel().reflectance(parameters);
  double sum = 0.0;
  for (std::size_t w = 0; w < nm.size(); ++w) {
    sum += std::pow(measured[w] - interpolated(spectrum, nm[w]), 2);
  }
  return std::sqrt(sum / static_cast<double>(nm.size()));
}

// The best of several starts over the box, by the plain solver.
double multistart(const std::vector<double>& nm, const double* measured, int starts) {
  SpectralNodes nodes;
  for (const double w : nm) {
    nodes.samples.push_back((static_cast<int>(w) - kFirstWavelengthNm) / kWavelengthStepNm);
  }
  const auto count = static_cast<Eigen::Index>(nm.size());
  nodes.weights = Eigen::MatrixXd::Identity(count, count);
  EstimatorOptions options;
  options.noise = {0.001, 0.0};
  const MapEstimator estimator(spectraModel(), nodes, options);
  const Eigen::VectorXd channels = Eigen::Map<const Eigen::VectorXd>(measured, count);
  double best = 1e9;
  for (const ParameterVector& start : sampleBox(spectraModel().profile().axes, starts, 777)) {
    best = std::min(best, estimator.solve(channels, start).residual.norm());
  }
  return best / std::sqrt(static_cast<double>(nm.size()));
}

class SpectraFitTest : public QObject {
  Q_OBJECT

 private slots:
  void recoversExactSpectra() {
    const auto people = sampleBox(spectraModel().profile().axes, 10000, 60000);
    const auto nm = wavelengths();
    const auto fits = fit(nm, spectraOf(people, nm));
    double worst = 0.0, sum = 0.0;
    for (std::size_t i = 0; i < people.size(); ++i) {
      worst = std::max(worst, fits[i].rmse);
      sum +=
          (spectraModel().reflectance(fits[i].parameters) - spectraModel().reflectance(people[i]))
              .segment(kVisibleBand.first, kVisibleBand.count())
              .square()
              .mean();
    }
    EXPECT_AT_MOST(worst, 1e-6);
    EXPECT_AT_MOST(sum / static_cast<double>(people.size()), 1e-12);
  }

  void endsAtTheGlobalOptimum_data() {
    QTest::addColumn<double>("noise");
    QTest::newRow("little noise") << 0.005;
    QTest::newRow("unlike skin") << 0.03;
  }
  void endsAtTheGlobalOptimum() {
    QFETCH(double, noise);
    const auto people = sampleBox(spectraModel().profile().axes, 100, 70000);
    const auto nm = wavelengths();
    const auto values = spectraOf(people, nm, noise);
    const auto fits = fit(nm, values);
    for (std::size_t i = 0; i < people.size(); ++i) {
      const double* measured = values.data() + i * nm.size();
      EXPECT_AT_MOST(fits[i].rmse, multistart(nm, measured, 12) + 1e-6);
      // What is reported is what the parameters give.
      EXPECT_NEAR(fits[i].rmse, rmse(fits[i].parameters, nm, measured), 1e-10);
      for (const Parameter k : kParameters) {
        QVERIFY(fits[i].parameters[k] >= 0.0);
        QVERIFY(fits[i].parameters[k] <= spectraModel().profile().axes[k].maximum);
      }
    }
  }

  // Little and much dermal blood fit about as well, with a rise between: one start is not enough.
  void findsTheDeeperOfTwoValleys() {
    const std::vector<ParameterVector> people = {{0.19, 0.0194525, 0.284039, 0.182552, 0.0006},
                                                 {0.177218, 0.0292256, 0.2876, 0.271816, 8e-6}};
    const auto nm = wavelengths();
    for (const SpectrumFit& found : fit(nm, spectraOf(people, nm))) {
      EXPECT_AT_MOST(found.rmse, 1e-6);
    }
  }

  // A blend has no slope without melanin, and at the most melanin only the sum of both kinds is
  // bounded.
  void reachesCornersOfTheBox() {
    const ParameterAxes& axes = spectraModel().profile().axes;
    std::vector<ParameterVector> people;
    for (int corner = 0; corner < 32; ++corner) {
      ParameterVector person;
      for (const Parameter k : kParameters) {
        person[k] = ((corner >> k) & 1) != 0 ? axes[k].maximum : 0.0;
      }
      people.push_back(person);
    }
    const auto nm = wavelengths();
    const auto fits = fit(nm, spectraOf(people, nm));
    for (const SpectrumFit& found : fits)
      EXPECT_AT_MOST(found.rmse, 1e-6);
    EXPECT_NEAR(fits[0].parameters[kMelanin], 0.0, 1e-6);
  }

  void whatIsNoSkinEndsInTheBox() {
    const auto nm = wavelengths();
    for (const double level : {0.0, 0.5, 1.5}) {
      const std::vector<double> flat(nm.size(), level);
      const auto fits = fit(nm, flat);
      EXPECT_AT_MOST(fits[0].rmse, multistart(nm, flat.data(), 12) + 1e-6);
    }
  }

  void takesAnyWavelengths() {
    const auto people = sampleBox(spectraModel().profile().axes, 50, 80000);
    std::vector<double> uneven, dense;
    for (double w = 301.3; w < 1000.0; w += 17.7)
      uneven.push_back(w);
    for (double w = 300.0; w <= 1000.0; w += 1.0)
      dense.push_back(w);
    for (const auto& nm : {uneven, dense, {300.0, 400.0, 500.0, 600.0, 1000.0}}) {
      for (const SpectrumFit& found : fit(nm, spectraOf(people, nm))) {
        EXPECT_AT_MOST(found.rmse, 1e-6);
      }
    }
  }

  void aResultIsItsOwnSpectrumsAlone() {
    const auto people = sampleBox(spectraModel().profile().axes, 100, 90000);
    const auto nm = wavelengths();
    const auto values = spectraOf(people, nm, 0.005);
    const auto together = fit(nm, values);
    for (const std::size_t i : {0U, 15U, 16U, 99U}) {
      const auto from = values.begin() + static_cast<std::ptrdiff_t>(i * nm.size());
      const auto alone = fit(nm, {from, from + static_cast<std::ptrdiff_t>(nm.size())});
      QVERIFY((alone[0].parameters == together[i].parameters).all());
      QVERIFY(alone[0].rmse == together[i].rmse);
    }
  }

  void stopsWhenAsked() {
    std::stop_source source;
    source.request_stop();
    JobContext context;
    context.stop = source.get_token();
    const auto nm = wavelengths();
    QVERIFY(
        fitSpectra(spectraModel(), nm, std::vector<double>(nm.size(), 0.3), context).cancelled());
  }

  void nothingGivesNothing() { QVERIFY(fit(wavelengths(), {}).empty()); }

  // The step of the lowest of all ways to hold coordinates at their bounds.
  void boundedStepsAreLowest() {
    expectLowestSteps<5>();
    expectLowestSteps<6>();
    expectLowestSteps<7>();
  }

 private:
  template <int N>
  void expectLowestSteps() {
    using Matrix = Eigen::Matrix<double, N, N>;
    using Vector = Eigen::Matrix<double, N, 1>;
    std::mt19937 random(5);
    std::normal_distribution<double> normal;
    std::uniform_real_distribution<double> uniform;
    for (int trial = 0; trial < 300; ++trial) {
      const Matrix root = Matrix::NullaryExpr([&] { return normal(random); });
      const Matrix hessian = root * root.transpose() + 1e-6 * Matrix::Identity();
      const Vector downhill = Vector::NullaryExpr([&] { return normal(random); });
      const Vector x =
          Vector::NullaryExpr([&] { return std::clamp(1.4 * uniform(random) - 0.2, 0.0, 1.0); });
      const BoundedStep<N> found = boundedStep(hessian, downhill, x);
      const Vector to = x + found.step;
      QVERIFY((to.array() >= -1e-15).all() && (to.array() <= 1.0 + 1e-15).all());
      const Vector slope = downhill - hessian * found.step;
      for (int i = 0; i < N; ++i) {
        const double scale = 1e-8 * (1.0 + hessian.norm());
        if (to[i] > 1e-12) QVERIFY(slope[i] > -scale);
        if (to[i] < 1.0 - 1e-12) QVERIFY(slope[i] < scale);
      }
    }
  }
};

CUTIS_TEST(SpectraFitTest)

}  // namespace
}  // namespace cutis

#include "spectra_fit_test.moc"
