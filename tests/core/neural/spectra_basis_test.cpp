#include "core/neural/spectra_basis.h"

#include <cmath>

#include <QtTest>
#include <tbb/global_control.h>

#include "tests/core/neural/neural_fixture.h"
#include "tests/support/expect.h"
#include "tests/support/models.h"
#include "tests/support/test_registry.h"

namespace cutis {
namespace {

// li2024 with a table of 720 entries.
SkinModel smallModel() {
  Profile profile = test::li2024().profile();
  const int samples[] = {6, 3, 5, 4, 2};
  for (std::size_t k = 0; k < profile.axes.size(); ++k)
    profile.axes[k].samples = samples[k];
  return SkinModel(profile);
}

// Every entry of the table, in any order.
std::vector<ParameterVector> tableOf(const ParameterAxes& axes) {
  std::vector<ParameterVector> people = {ParameterVector::Zero()};
  for (std::size_t k = 0; k < axes.size(); ++k) {
    std::vector<ParameterVector> next;
    for (ParameterVector p : people) {
      for (int i = 0; i < axes[k].samples; ++i) {
        p[static_cast<Eigen::Index>(k)] = axes[k].value(i);
        next.push_back(p);
      }
    }
    people = std::move(next);
  }
  return people;
}

class SpectraBasisTest : public QObject {
  Q_OBJECT

 private slots:
  void componentsAreOrthonormal() {
    const Eigen::MatrixXd& components = test::sampledBasis().components;
    QCOMPARE(components.rows(), Eigen::Index{kSampleCount});
    QCOMPARE(components.cols(), Eigen::Index{kMaximumComponents});
    const Eigen::MatrixXd gram = components.transpose() * components;
    const Eigen::MatrixXd identity =
        Eigen::MatrixXd::Identity(kMaximumComponents, kMaximumComponents);
    EXPECT_AT_MOST((gram - identity).cwiseAbs().maxCoeff(), 1e-12);
    for (Eigen::Index k = 0; k < components.cols(); ++k) {
      QVERIFY(components.col(k).maxCoeff() >= -components.col(k).minCoeff());
    }
  }

  void truncationFallsWithTheNumber() {
    const SpectraBasis& basis = test::sampledBasis();
    for (int n = 1; n <= kMaximumComponents; ++n) {
      QVERIFY(basis.truncationError(n) <= basis.truncationError(n - 1));
    }
    // Measured over the whole table: 4.5e-7 and 2.9e-9.
    EXPECT_AT_MOST(basis.truncationError(10), 6e-7);
    EXPECT_AT_MOST(basis.truncationError(20), 5e-9);
    for (const double error : {1e-5, 1e-7, 1e-9}) {
      const int count = basis.componentsFor(error);
      EXPECT_AT_MOST(basis.truncationError(count), error);
      QVERIFY(basis.truncationError(count - 1) > error);
    }
    QCOMPARE(basis.componentsFor(0.0), kMaximumComponents);
    QCOMPARE(basis.componentsFor(1.0), 0);
  }

  // Mean, and what is left by n components, straight from their definitions.
  void agreesWithTheDefinition() {
    const SkinModel model = smallModel();
    const auto result = computeSpectraBasis(model, {});
    EXPECT_OK(result);
    const SpectraBasis& basis = result.value();
    const std::vector<ParameterVector> people = tableOf(model.profile().axes);
    QCOMPARE(basis.spectra, std::int64_t{6 * 3 * 5 * 4 * 2});
    QCOMPARE(people.size(), std::size_t{6 * 3 * 5 * 4 * 2});
    Eigen::MatrixXd spectra(static_cast<Eigen::Index>(people.size()), kSampleCount);
    for (std::size_t i = 0; i < people.size(); ++i) {
      spectra.row(static_cast<Eigen::Index>(i)) = model.reflectance(people[i]).matrix().transpose();
    }
    const Eigen::RowVectorXd mean = spectra.colwise().mean();
    EXPECT_AT_MOST((mean.transpose() - basis.mean.matrix()).cwiseAbs().maxCoeff(), 2e-6);
    const Eigen::MatrixXd away = spectra.rowwise() - basis.mean.matrix().transpose();
    for (const int n : {0, 1, 4, 10, 16}) {
      const Eigen::MatrixXd components = basis.components.leftCols(n);
      const Eigen::MatrixXd left = away - away * components * components.transpose();
      const double error = left.squaredNorm() / static_cast<double>(left.size());
      EXPECT_NEAR(basis.truncationError(n), error, 1e-3 * error + 1e-12);
    }
  }

  void threadsDoNotMatter() {
    const SkinModel model = smallModel();
    const auto several = computeSpectraBasis(model, {});
    EXPECT_OK(several);
    const tbb::global_control limit(tbb::global_control::max_allowed_parallelism, 1);
    const auto alone = computeSpectraBasis(model, {});
    EXPECT_OK(alone);
    QVERIFY(alone.value().components == several.value().components);
    QVERIFY(alone.value().variances == several.value().variances);
    QVERIFY((alone.value().mean == several.value().mean).all());
  }

  void cancels() {
    std::stop_source stop;
    stop.request_stop();
    JobContext context;
    context.stop = stop.get_token();
    QVERIFY(computeSpectraBasis(test::li2024(), context).cancelled());
  }
};

CUTIS_TEST(SpectraBasisTest)

}  // namespace
}  // namespace cutis

#include "spectra_basis_test.moc"
