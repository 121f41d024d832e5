// The fit with what the model leaves over: against the same estimate written down plainly, and
// against people drawn with a discrepancy.

#include <cmath>

#include <Eigen/Cholesky>
#include <QtTest>

#include "core/base/random.h"
#include "core/fit/assumed_noise.h"
#include "core/fit/discrepancy_choice.h"
#include "core/fit/population.h"
#include "core/fit/refined/refined_solver.h"
#include "core/fit/spectrum_posterior.h"
#include "src/files/profiles/profile_file.h"
#include "tests/core/fit/fit_fixture.h"
#include "tests/support/models.h"
#include "tests/support/test_registry.h"

namespace cutis {
// Its own, since tests of a folder are compiled together.
namespace discrepancy_fit {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

constexpr int kPeople = 400;
constexpr NoiseModel kNoise = {0.0001, 0.005};

std::shared_ptr<const SkinModel> model() {
  static const auto made = SkinModel::create(loadProfile("skin2026b", "test").value()).value();
  return made;
}

const Discrepancy& discrepancy() {
  return *model()->profile().discrepancies.of(SurfaceLight::included);
}

// People with a discrepancy of their own.
struct People {
  std::vector<std::vector<double>> values;  // parameters, then coefficients
  std::vector<Spectrum> spectra;
  test::PixelSet pixels;
};

VectorXd coordinatesOf(const ParameterVector& parameters) {
  VectorXd x(int{kParameterCount});
  for (int i = 0; i < kParameterCount; ++i)
    x[i] = discrepancy().prior.isLog(i) ? std::log(parameters[i]) : parameters[i];
  return x;
}

People draw(const Rig& rig, double noise, std::uint64_t seed) {
  People people;
  const SpectrumRows rows = responseRows(rig);
  const auto parameters =
      drawFromPrior(discrepancy().prior, model()->profile().axes, kPeople, seed);
  const MatrixXd root = discrepancy().covariance.llt().matrixL();
  const VectorXd mean = coordinatesOf(discrepancy().prior.mean);
  Random random(seed, 7);
  const auto count = static_cast<std::size_t>(kPeople);
  people.pixels.count = count;
  people.pixels.channels.resize(count * static_cast<std::size_t>(rows.rows()));
  for (std::size_t p = 0; p < count; ++p) {
    VectorXd drawn(root.cols());
    for (double& value : drawn)
      value = random.normal();
    const VectorXd z = discrepancy().slope * (coordinatesOf(parameters[p]) - mean) + root * drawn;
    VectorXd unseen(discrepancy().rest.cols());
    for (double& value : unseen)
      value = random.normal();
    const Spectrum spectrum = model()->reflectance(parameters[p]) *
                              (discrepancy().factor(z) + (discrepancy().rest * unseen).array());
    for (Index k = 0; k < rows.rows(); ++k) {
      const double channel = (rows.row(k).transpose() * spectrum).sum();
      people.pixels.channels[static_cast<std::size_t>(k) * count + p] =
          static_cast<float>(channel * (1.0 + noise * random.normal()));
    }
    std::vector<double> values(parameters[p].begin(), parameters[p].end());
    values.insert(values.end(), z.begin(), z.end());
    people.values.push_back(values);
    people.spectra.push_back(spectrum);
  }
  return people;
}

PixelBuffer<float> solved(const PixelSolver& solver, const test::PixelSet& pixels) {
  PixelBuffer<float> values(solver.valueCount(), pixels.count);
  std::vector<PixelState> states(pixels.count);
  std::vector<std::uint16_t> iterations(pixels.count);
  solver.solve(pixels.rows(), values.rows(), {states.data(), iterations.data()});
  return values;
}

std::vector<double> valuesAt(const PixelBuffer<float>& values, std::size_t pixel) {
  std::vector<double> all;
  for (std::size_t k = 0; k < values.rowCount(); ++k)
    all.push_back(double{values[k][pixel]});
  return all;
}

FitOptions optionsOf(bool on) {
  FitOptions options;
  options.noise = kNoise;
  options.discrepancy = on;
  return options;
}

// What the fit minimises over parameters and coefficients together, with whole spectra.
struct JointCost {
  const SpectrumRows rows = responseRows(test::monitorRig());
  const VectorXd mean = coordinatesOf(discrepancy().prior.mean);
  const ParameterMatrix precision = discrepancy().prior.precision();
  const MatrixXd inner = discrepancy().covariance.inverse();

  double at(const VectorXd& channels, const VectorXd& x, const VectorXd& z) const {
    ParameterVector parameters;
    for (int i = 0; i < kParameterCount; ++i)
      parameters[i] = discrepancy().prior.isLog(i) ? std::exp(x[i]) : x[i];
    const Spectrum spectrum = model()->reflectance(parameters) * discrepancy().factor(z);
    double cost = 0.0;
    for (Index k = 0; k < rows.rows(); ++k) {
      const double r = channels[k] - (rows.row(k).transpose() * spectrum).sum();
      cost += r * r / kNoise.variance(channels[k]);
    }
    const VectorXd away = x - mean;
    const VectorXd own = z - discrepancy().slope * away;
    return cost + away.dot(precision * away) + own.dot(inner * own);
  }
};

class DiscrepancyFitTest : public QObject {
  Q_OBJECT

 private slots:
  void withoutItThereAreTheBytesOfTheProfileWithout() {
    Profile plain = model()->profile();
    plain.discrepancies = {};
    const auto without =
        makeRefinedSolver(SkinModel::create(plain).value(), test::monitorRig(), optionsOf(true));
    const auto off = makeRefinedSolver(model(), test::monitorRig(), optionsOf(false));
    QCOMPARE(off->valueCount(), std::size_t{kParameterCount});
    const People people = draw(test::monitorRig(), 0.005, 1);
    const auto a = solved(*without, people.pixels), b = solved(*off, people.pixels);
    for (std::size_t p = 0; p < people.pixels.count; ++p)
      QVERIFY(valuesAt(a, p) == valuesAt(b, p));
  }

  void theExactSettingAsksForNone() {
    FitOptions exact;
    exact.noise = NoiseModel{0.0, 0.0};
    QVERIFY(chosenDiscrepancy(model()->profile(), test::monitorRig(), exact) == nullptr);
    exact.discrepancy = true;
    QVERIFY(chosenDiscrepancy(model()->profile(), test::monitorRig(), exact) != nullptr);
    FitOptions usual;
    QVERIFY(chosenDiscrepancy(model()->profile(), test::monitorRig(), usual) != nullptr);
    usual.free.oxygenation = true;
    QVERIFY(chosenDiscrepancy(model()->profile(), test::monitorRig(), usual) == nullptr);
  }

  // Hardly any step of parameters and coefficients leads lower than a small part of a deviation²:
  // what there is comes from how much of a change channels see, which the fit takes from the
  // prior's mean.
  void isTheLowestPointOfTheJointCost() {
    const auto solver = makeRefinedSolver(model(), test::monitorRig(), optionsOf(true));
    const People people = draw(test::monitorRig(), 0.005, 2);
    const auto found = solved(*solver, people.pixels);
    const SpectrumPosterior posterior(*model(), test::monitorRig(), optionsOf(true));
    const JointCost cost;
    const int count = discrepancy().count();
    int poor = 0;
    for (std::size_t p = 0; p < 100; ++p) {
      const VectorXd channels = people.pixels.at(p);
      const auto values = valuesAt(found, p);
      ParameterVector parameters;
      std::copy_n(values.begin(), kParameterCount, parameters.begin());
      const VectorXd x = coordinatesOf(parameters);
      const VectorXd z = Eigen::Map<const VectorXd>(values.data() + kParameterCount, Index{count});
      const MatrixXd covariance = posterior.covariance(
          std::span(channels.data(), static_cast<std::size_t>(channels.size())), values);
      const double here = cost.at(channels, x, z);
      // The gradient by central differences, in units of the posterior.
      VectorXd gradient(x.size() + z.size());
      for (Index i = 0; i < gradient.size(); ++i) {
        const double step = 1e-3 * std::sqrt(covariance(i, i));
        VectorXd xa = x, xb = x, za = z, zb = z;
        (i < x.size() ? xa[i] : za[i - x.size()]) += step;
        (i < x.size() ? xb[i] : zb[i - x.size()]) -= step;
        gradient[i] = (cost.at(channels, xa, za) - cost.at(channels, xb, zb)) / (2.0 * step);
      }
      // Parameters at an end of their range may want out.
      bool atBound = false;
      for (int i = 0; i < kParameterCount; ++i) {
        const double most = model()->profile().axes[static_cast<std::size_t>(i)].maximum;
        atBound = atBound || values[static_cast<std::size_t>(i)] < 1e-5 * most ||
                  values[static_cast<std::size_t>(i)] > 0.9999 * most;
      }
      if (atBound) continue;
      QVERIFY(std::isfinite(here));
      // What a Newton step would still gain.
      const double gain = 0.25 * gradient.dot(covariance * gradient);
      if (gain > 0.1) ++poor;
    }
    QVERIFY2(poor <= 6, qPrintable(QString::number(poor)));
  }

  void covarianceIsThatOfTheCost() {
    const People people = draw(test::monitorRig(), 0.005, 3);
    const SpectrumPosterior posterior(*model(), test::monitorRig(), optionsOf(true));
    const JointCost cost;
    const Index count = kParameterCount + discrepancy().count();
    for (std::size_t p = 0; p < 5; ++p) {
      const auto& values = people.values[p];
      // Without residuals Gauss–Newton's matrix is the cost's curvature.
      const SpectrumRows rows = responseRows(test::monitorRig());
      const Spectrum spectrum = posterior.reflectance(values);
      const VectorXd channels = rows.matrix() * spectrum.matrix();
      const MatrixXd covariance = posterior.covariance(
          std::span(channels.data(), static_cast<std::size_t>(channels.size())), values);
      ParameterVector parameters;
      std::copy_n(values.begin(), kParameterCount, parameters.begin());
      VectorXd at(count);
      at << coordinatesOf(parameters),
          Eigen::Map<const VectorXd>(values.data() + kParameterCount, Index{discrepancy().count()});
      const auto costAt = [&](const VectorXd& u) {
        return cost.at(channels, u.head(kParameterCount), u.tail(discrepancy().count()));
      };
      MatrixXd hessian(count, count);
      const VectorXd step = 0.02 * covariance.diagonal().cwiseSqrt();
      for (Index i = 0; i < count; ++i) {
        for (Index j = 0; j <= i; ++j) {
          double sum = 0.0;
          for (const auto& [a, b] : {std::pair{1.0, 1.0}, {-1.0, -1.0}, {1.0, -1.0}, {-1.0, 1.0}}) {
            VectorXd u = at;
            u[i] += a * step[i];
            u[j] += b * step[j];
            sum += a * b * costAt(u);
          }
          hessian(i, j) = hessian(j, i) = 0.5 * sum / (4.0 * step[i] * step[j]);
        }
      }
      const MatrixXd expected = hessian.inverse();
      for (Index i = 0; i < count; ++i) {
        const double ratio = covariance(i, i) / expected(i, i);
        QVERIFY2(ratio > 0.9 && ratio < 1.1,
                 qPrintable(QString("%1 of %2: %3").arg(i).arg(p).arg(ratio)));
      }
    }
  }

  // Two deviations hold what they should of people who are as the profile says.
  void bandsHoldThePeople_data() {
    QTest::addColumn<bool>("monitor");
    QTest::newRow("nine channels") << true;
    QTest::newRow("a colour") << false;
  }
  void bandsHoldThePeople() {
    QFETCH(bool, monitor);
    const Rig& rig = monitor ? test::monitorRig() : test::albedoRig();
    const auto solver = makeRefinedSolver(model(), rig, optionsOf(true));
    const People people = draw(rig, 0.005, 4);
    const auto found = solved(*solver, people.pixels);
    const SpectrumPosterior posterior(*model(), rig, optionsOf(true));
    double held = 0.0;
    for (std::size_t p = 0; p < people.pixels.count; ++p) {
      const VectorXd channels = people.pixels.at(p);
      const auto values = valuesAt(found, p);
      const Spectrum away = (posterior.reflectance(values) - people.spectra[p]).abs();
      const Spectrum deviation = posterior.deviation(
          std::span(channels.data(), static_cast<std::size_t>(channels.size())), values);
      held += (away <= 2.0 * deviation).cast<double>().mean();
    }
    held /= static_cast<double>(people.pixels.count);
    QVERIFY2(held > 0.91 && held < 0.985, qPrintable(QString::number(held)));
  }

  void channelsAreMetWithinTheirNoise() {
    const auto solver = makeRefinedSolver(model(), test::monitorRig(), optionsOf(true));
    const People people = draw(test::monitorRig(), 0.005, 5);
    const auto found = solved(*solver, people.pixels);
    PixelBuffer<float> residuals(people.pixels.channelCount(), people.pixels.count);
    solver->residuals(people.pixels.rows(), found.rows(), residuals.rows());
    double sum = 0.0;
    for (std::size_t k = 0; k < residuals.rowCount(); ++k) {
      for (std::size_t p = 0; p < residuals.count(); ++p) {
        const double y = double{people.pixels.rows().at(k, p)};
        sum += std::pow(double{residuals[k][p]}, 2) / kNoise.variance(y);
      }
    }
    const double mean = sum / static_cast<double>(residuals.rowCount() * residuals.count());
    QVERIFY2(mean < 1.0, qPrintable(QString::number(mean)));
  }

  void aPixelKnowsNothingOfItsNeighbours() {
    const auto solver = makeRefinedSolver(model(), test::monitorRig(), optionsOf(true));
    const People people = draw(test::monitorRig(), 0.005, 6);
    const auto together = solved(*solver, people.pixels);
    for (const std::size_t p : {std::size_t{0}, std::size_t{7}, std::size_t{113}}) {
      std::vector<float> alone;
      for (std::size_t k = 0; k < people.pixels.channelCount(); ++k)
        alone.push_back(people.pixels.rows().at(k, p));
      const auto single = solved(*solver, test::pixelsOf({alone}));
      QVERIFY(valuesAt(single, 0) == valuesAt(together, p));
    }
  }

  // An unknown factor on all channels takes away from what they say, above all of brightness.
  void shadingLeavesMoreOpen() {
    const People people = draw(test::monitorRig(), 0.005, 9);
    FitOptions shaded = optionsOf(true);
    shaded.shading = 0.1;
    const SpectrumPosterior plain(*model(), test::monitorRig(), optionsOf(true));
    const SpectrumPosterior open(*model(), test::monitorRig(), shaded);
    for (std::size_t p = 0; p < 5; ++p) {
      const auto& values = people.values[p];
      const Spectrum a = plain.deviation(plain.channels(values), values);
      const Spectrum b = open.deviation(open.channels(values), values);
      // A fit that leaves more open also makes less of the rest's share in the channels.
      const double least = (b / a).minCoeff();
      QVERIFY2(least > 0.95 && b.sum() > 1.2 * a.sum(), qPrintable(QString::number(least)));
      const int green = (550 - kFirstWavelengthNm) / kWavelengthStepNm;
      const double reflectance = open.reflectance(values)[green];
      QVERIFY2(b[green] > 2.0 * a[green] && b[green] < 0.1 * reflectance + a[green],
               qPrintable(QString("%1 %2 %3").arg(a[green]).arg(b[green]).arg(reflectance)));
    }
  }

  // What is no skin is not explained away.
  void coefficientsHaveALimit() {
    const auto solver = makeRefinedSolver(model(), test::monitorRig(), optionsOf(true));
    const test::PixelSet pixels =
        test::pixelsOf({{0.02f, 0.4f, 0.02f, 0.02f, 0.4f, 0.02f, 0.02f, 0.4f, 0.02f},
                        {1e-6f, 1e-6f, 1e-6f, 1e-6f, 1e-6f, 1e-6f, 1e-6f, 1e-6f, 1e-6f},
                        {5.0f, 5.0f, 5.0f, 5.0f, 5.0f, 5.0f, 5.0f, 5.0f, 5.0f}});
    const auto found = solved(*solver, pixels);
    for (std::size_t p = 0; p < pixels.count; ++p) {
      double square = 0.0;
      for (std::size_t k = kParameterCount; k < found.rowCount(); ++k) {
        QVERIFY(std::isfinite(found[k][p]));
        square += std::pow(double{found[k][p]}, 2);
      }
      QVERIFY(std::sqrt(square) <= kMostCoefficientNorm * 1.0001);
    }
  }

  // What the model leaves over is nothing that is known of the parameters.
  void deviationsGrow() {
    const People people = draw(test::monitorRig(), 0.005, 8);
    const auto with = makeRefinedSolver(model(), test::monitorRig(), optionsOf(true));
    FitOptions off = optionsOf(false);
    off.prior = discrepancy().prior;
    const auto without = makeRefinedSolver(model(), test::monitorRig(), off);
    const auto found = solved(*with, people.pixels);
    PixelBuffer<float> a(found.rowCount(), people.pixels.count),
        b(kParameterCount, people.pixels.count);
    PixelBuffer<float> five(kParameterCount, people.pixels.count);
    for (std::size_t k = 0; k < kParameterCount; ++k)
      std::copy(found[k].begin(), found[k].end(), five[k].begin());
    with->deviations(people.pixels.rows(), found.rows(), a.rows());
    without->deviations(people.pixels.rows(), five.rows(), b.rows());
    double more = 0.0, less = 0.0;
    for (std::size_t p = 0; p < people.pixels.count; ++p) {
      more += double{a[kMelanin][p]};
      less += double{b[kMelanin][p]};
    }
    QVERIFY2(more > less, qPrintable(QString("%1 %2").arg(more).arg(less)));
  }
};

CUTIS_TEST(DiscrepancyFitTest)

}  // namespace
}  // namespace discrepancy_fit
}  // namespace cutis

#include "discrepancy_fit_test.moc"
