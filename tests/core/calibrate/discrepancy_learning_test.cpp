// A discrepancy that made spectra is found from the spectra again, whatever the order of people and
// the number of threads; one odd spectrum does not lead it astray; what cannot be learned from is
// refused.

#include "core/calibrate/discrepancy_learning.h"

#include <cmath>
#include <numbers>

#include <QtTest>
#include <tbb/global_control.h>

#include "core/base/random.h"
#include "core/fit/population.h"
#include "core/maths/decompositions.h"
#include "tests/support/expect.h"
#include "tests/support/models.h"
#include "tests/support/test_registry.h"

namespace cutis {
namespace {

using Eigen::Index;
using Eigen::VectorXd;

constexpr int kPeople = 40;

// Waves are shorter than anything that the parameters could follow.
double wave(double wavelength, double length, double amplitude) {
  return amplitude * std::sin(2.0 * std::numbers::pi * wavelength / length);
}
double trueMean(double wavelength) {
  return wave(wavelength, 60.0, 0.04);
}
double trueComponent(double wavelength) {
  return wave(wavelength + 10.0, 75.0, 0.03);
}

std::vector<int> everyFourNm(int fromNm, int toNm) {
  std::vector<int> samples;
  for (int wavelength = fromNm; wavelength <= toNm; wavelength += 4)
    samples.push_back((wavelength - kFirstWavelengthNm) / kWavelengthStepNm);
  return samples;
}

SpectraSet madeSpectra(int fromNm, int toNm) {
  const SkinModel& model = test::li2024();
  Prior prior = model.profile().prior;
  prior.deviation *= 0.5;
  const auto people = drawFromPrior(prior, model.profile().axes, kPeople, 4);
  Random random(6);
  SpectraSet set;
  set.samples = everyFourNm(fromNm, toNm);
  set.measured.resize(static_cast<Index>(set.samples.size()), kPeople);
  for (Index i = 0; i < kPeople; ++i) {
    const double coefficient = random.normal();
    for (Index s = 0; s < set.measured.rows(); ++s) {
      const int sample = set.samples[static_cast<std::size_t>(s)];
      const double wavelength = wavelengthNm(sample);
      set.measured(s, i) = model.reflectanceAt(sample, people[static_cast<std::size_t>(i)]) *
                           (1.0 + trueMean(wavelength) + coefficient * trueComponent(wavelength));
    }
  }
  return set;
}

DiscrepancyLearning optionsFor(int components) {
  DiscrepancyLearning options;
  options.components = components;
  options.prior = test::li2024().profile().prior;
  return options;
}

Discrepancy learnedFrom(const SpectraSet& set) {
  return std::move(learnDiscrepancy(test::li2024(), set, optionsFor(4), {})).value();
}

// Root mean square from 420 to 680 nm.
template <typename Value>
double rmsOf(const Value& value) {
  double sum = 0.0;
  int count = 0;
  for (int sample = 60; sample <= 190; ++sample, ++count)
    sum += value(sample) * value(sample);
  return std::sqrt(sum / count);
}

// What everybody has in common may be their parameters or the mean: less the combination of the
// model's derivatives that comes closest from 420 to 680 nm.
VectorXd withoutWhatSkinExplains(const VectorXd& relative) {
  const SkinModel& model = test::li2024();
  SpectrumJacobian derivatives;
  const Spectrum typical = model.reflectance(model.profile().prior.mean, derivatives);
  const Eigen::MatrixXd logarithmic = typical.inverse().matrix().asDiagonal() *
                                      derivatives.matrix() *
                                      model.profile().prior.mean.matrix().asDiagonal();
  const auto visible = logarithmic.middleRows(60, 131);
  const VectorXd explained = solvePositive(Eigen::MatrixXd(visible.transpose() * visible),
                                           visible.transpose() * relative.segment(60, 131));
  return relative - logarithmic * explained;
}

Eigen::MatrixXd covarianceOfRest(const Discrepancy& discrepancy) {
  Eigen::MatrixXd covariance = discrepancy.rest * discrepancy.rest.transpose();
  covariance.diagonal() += discrepancy.independentDeviation.square().matrix();
  return covariance;
}

Eigen::MatrixXd covarianceOf(const Discrepancy& discrepancy) {
  return discrepancy.components * discrepancy.components.transpose() +
         covarianceOfRest(discrepancy);
}

class DiscrepancyLearningTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void initTestCase() {
    set_ = madeSpectra(320, 1000);
    learned_ = learnedFrom(set_);
  }

  void meanAndCovarianceThatMadeTheSpectraAreFound() {
    EXPECT_OK(validate(learned_, "the discrepancy", ""));
    VectorXd missed(int{kSampleCount});
    for (int i = 0; i < kSampleCount; ++i)
      missed[i] = learned_.mean[i] - trueMean(wavelengthNm(i));
    EXPECT_AT_MOST(rmsOf(withoutWhatSkinExplains(missed)), 0.006);
    // The first component is the wave that varies, up to its sign, and as strong.
    VectorXd truth(int{kSampleCount});
    for (int i = 0; i < kSampleCount; ++i)
      truth[i] = trueComponent(wavelengthNm(i));
    const auto visible = [](const VectorXd& spectrum) { return spectrum.segment(60, 131); };
    const VectorXd first = learned_.components.col(0);
    const double overlap =
        visible(first).dot(visible(truth)) / (visible(first).norm() * visible(truth).norm());
    EXPECT_NEAR(std::abs(overlap), 1.0, 0.1);
    EXPECT_NEAR(visible(first).norm() / visible(truth).norm(), 1.0, 0.25);
  }

  // Coefficients have the variance 1 over people.
  void coefficientsAreNormalised() {
    const auto deviations = learned_.prior.deviation.matrix().asDiagonal();
    const Eigen::MatrixXd people = deviations * learned_.prior.correlation * deviations;
    const Eigen::MatrixXd total =
        learned_.covariance + learned_.slope * people * learned_.slope.transpose();
    EXPECT_NEAR((total - Eigen::MatrixXd::Identity(4, 4)).norm(), 0.0, 1e-6);
  }

  void theOrderOfPeopleDoesNotMatter() {
    SpectraSet other = set_;
    other.measured = set_.measured.rowwise().reverse();
    const Discrepancy again = learnedFrom(other);
    EXPECT_NEAR((again.mean - learned_.mean).abs().maxCoeff(), 0.0, 1e-6);
    EXPECT_NEAR((covarianceOf(again) - covarianceOf(learned_)).cwiseAbs().maxCoeff(), 0.0, 1e-6);
  }

  void theNumberOfThreadsDoesNotMatter() {
    const tbb::global_control oneThread(tbb::global_control::max_allowed_parallelism, 1);
    const Discrepancy again = learnedFrom(set_);
    QVERIFY((again.mean == learned_.mean).all());
    QVERIFY(again.components == learned_.components);
    QVERIFY(again.covariance == learned_.covariance);
    QVERIFY(again.rest == learned_.rest);
    QVERIFY((again.independentDeviation == learned_.independentDeviation).all());
  }

  void anOddSpectrumCountsForLittle() {
    SpectraSet odd = set_;
    for (Index s = 0; s < odd.measured.rows(); ++s)
      odd.measured(s, 7) = s % 9 < 4 ? 0.9 : 0.01;
    const Discrepancy again = learnedFrom(odd);
    EXPECT_AT_MOST(rmsOf([&](int i) { return again.mean[i] - learned_.mean[i]; }), 0.01);
    const double before = covarianceOf(learned_).diagonal().segment(60, 131).sum();
    const double after = covarianceOf(again).diagonal().segment(60, 131).sum();
    EXPECT_AT_MOST(after, 2.0 * before);
  }

  // What no component tells, such as noise of every sample by itself, is held by the rest, at its
  // true size though it was learned from few, and most of it as independent of other wavelengths.
  void theRestHoldsPeopleLeftOut() {
    SpectraSet noisy = set_;
    Random random(9);
    for (Index i = 0; i < noisy.measured.cols(); ++i) {
      for (Index s = 0; s < noisy.measured.rows(); ++s)
        noisy.measured(s, i) *= 1.0 + 0.01 * random.normal();
    }
    for (const Index people : {Index{16}, Index{kPeople}}) {
      SpectraSet some = noisy;
      some.measured = noisy.measured.leftCols(people).eval();
      const Discrepancy learned = learnedFrom(some);
      const VectorXd deviation = covarianceOfRest(learned).diagonal().cwiseSqrt();
      const double typical = rmsOf([&](int i) { return deviation[i]; });
      QVERIFY2(typical > 0.009 && typical < 0.02, qPrintable(QString::number(typical)));
      const double independent = rmsOf([&](int i) { return learned.independentDeviation[i]; });
      QVERIFY2(independent > 0.6 * typical, qPrintable(QString::number(independent)));
    }
  }

  // Where nothing was measured, the mean fades and much is left open.
  void aShorterRangeIsExtended() {
    const Discrepancy shorter = learnedFrom(madeSpectra(360, 740));
    EXPECT_AT_MOST(rmsOf([&](int i) { return shorter.mean[i] - learned_.mean[i]; }), 0.015);
    EXPECT_NEAR(shorter.mean[kSampleCount - 1], 0.0, 1e-3);
    const VectorXd deviation = covarianceOf(shorter).diagonal().cwiseSqrt();
    QVERIFY(deviation[300] > 0.04);
    QVERIFY(deviation[300] > 3.0 * covarianceOf(learned_).diagonal().cwiseSqrt()[300] - 0.1);
  }

  void whatCannotBeLearnedFromIsRefused() {
    const auto refusal = [](const SpectraSet& set, int components) {
      const auto result = learnDiscrepancy(test::li2024(), set, optionsFor(components), {});
      return result.failed() ? result.error().text() : std::string("none");
    };
    SpectraSet few = set_;
    few.measured = set_.measured.leftCols(7).eval();
    QCOMPARE(refusal(few, 4), std::string("the spectra: too few people to learn from: 7 where at "
                                          "least 8 are needed"));
    few.measured = set_.measured.leftCols(8).eval();
    QVERIFY(refusal(few, 8).find("at least 9") != std::string::npos);
    SpectraSet dark = set_;
    dark.measured(3, 5) = 0.0;
    QVERIFY(refusal(dark, 4).find("spectrum 6 has a reflectance that is not positive at 332 nm") !=
            std::string::npos);
    QVERIFY(refusal(madeSpectra(420, 1000), 4).find("from 400 to 700 nm") != std::string::npos);
    std::stop_source source;
    source.request_stop();
    QVERIFY(learnDiscrepancy(test::li2024(), set_, optionsFor(4), {source.get_token(), {}, {}})
                .cancelled());
  }

 private:
  SpectraSet set_;
  Discrepancy learned_;
};

CUTIS_TEST(DiscrepancyLearningTest)

}  // namespace
}  // namespace cutis

#include "discrepancy_learning_test.moc"
